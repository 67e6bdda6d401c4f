// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/motion_progress.h"

#include "smore/common/speed_scaling.h"

namespace smore {
namespace {

// A robot at rest moved less than this [m + rad] during the last 10 ms; all times are the motion's.
constexpr double kAtRest = 1e-4;
constexpr double kRestTime = 0.01;
// Share of the motion's time before which no arrival counts.
constexpr double kEarliest = 0.9;
// A robot that stands for so long [s] was stopped.
constexpr double kStallTime = 0.5;
// A motion may take so many times what its speed says, and so much more [s].
constexpr double kSlowness = 3.0;
constexpr double kSlack = 5.0;

}  // namespace

MotionProgress::MotionProgress(double time, const Pose& here, const Pose& target, double duration)
    : time_(time), target_(target), duration_(duration), last_(here), rest_pose_(here) {}

MotionStage MotionProgress::update(double time, const Pose& here, double scaling) {
  const double passed = scaling < kLeastScaling ? 0.0 : scaling * (time - time_);
  time_ = time;
  elapsed_ += passed;
  rest_ += passed;
  length_ += distanceBetween(last_, here);
  last_ = here;
  if (gapBetween(rest_pose_, here) > kAtRest) {
    rest_pose_ = here;
    rest_ = 0.0;
  }
  const bool may_arrive = elapsed_ >= kEarliest * duration_;
  if (rest_ >= kRestTime && may_arrive && gapBetween(here, target_) < kAtTarget) {
    return MotionStage::kArrived;
  }
  if (elapsed_ > kSlowness * duration_ + kSlack) {
    const bool has_ended = rest_ >= kStallTime && isNearTarget(here);
    return has_ended ? MotionStage::kArrived : MotionStage::kLate;
  }
  return rest_ >= kStallTime ? MotionStage::kStalled : MotionStage::kUnderWay;
}

// A compliant robot that stands there comes no nearer.
bool MotionProgress::isNearTarget(const Pose& here) const {
  return distanceBetween(here, target_) <= kNearDistance &&
         angleBetween(here, target_) <= kNearAngle;
}

void MotionProgress::setOutAgain(double duration) {
  duration_ = duration;
  elapsed_ = rest_ = 0.0;
}

}  // namespace smore
