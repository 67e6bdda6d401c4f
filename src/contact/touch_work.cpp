// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/touch_work.h"

namespace smore {

double touchWorkShare(const LineOfAction& line, const Pose& from, const Pose& to) {
  const Pose way = from.inverse() * to;
  const Eigen::AngleAxisd turn(way.linear());
  const Vec3 rotation = turn.angle() * turn.axis();
  const Vec3 moment = line.point.cross(line.direction) + line.pitch * line.direction;
  const double most = way.translation().norm() + moment.norm() * rotation.norm();
  if (most <= 0.0) return 0.0;
  return (line.direction.dot(way.translation()) + moment.dot(rotation)) / most;
}

}  // namespace smore
