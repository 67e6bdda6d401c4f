// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/collision_checker.h"

namespace smore {
namespace {

/// A motion at constant rates, of which the stretch [begin, end] (shares of the whole) is to be
/// checked.
class MotionCheck {
 public:
  MotionCheck(const CollisionChecker& checker, const Pose& from, const Pose& to, double depth)
      : checker_(checker),
        from_(from),
        to_(to),
        depth_(depth),
        travel_(distanceBetween(from, to) + checker.objectRadius() * angleBetween(from, to)) {}

  bool isFree(double begin, double end) const {
    const double middle = 0.5 * (begin + end);
    const double reach = 0.5 * (end - begin) * travel_;
    const double clearance = checker_.clearance(interpolate(from_, to_, middle), reach);
    if (clearance < 0.0) return false;
    if (reach <= clearance || reach <= depth_) return true;
    // What the clearance proves needs no second look; the rest lies on both sides of it.
    const double proven = clearance / travel_;
    return isFree(begin, middle - proven) && isFree(middle + proven, end);
  }

 private:
  const CollisionChecker& checker_;
  const Pose& from_;
  const Pose& to_;
  double depth_;
  double travel_;  ///< no point of the object moves further [m]
};

}  // namespace

bool isMotionFree(const CollisionChecker& checker, const Pose& from, const Pose& to, double depth) {
  if (checker.inCollision(to)) return false;
  return MotionCheck(checker, from, to, depth).isFree(0.0, 1.0);
}

}  // namespace smore
