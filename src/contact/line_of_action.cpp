// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/line_of_action.h"

#include <cmath>
#include <sstream>

namespace smore {

bool isFinite(const LineOfAction& line) {
  return line.point.allFinite() && line.direction.allFinite() && std::isfinite(line.force) &&
         std::isfinite(line.pitch) && std::isfinite(line.direction_stddev) &&
         std::isfinite(line.offset_stddev);
}

Result<LineOfAction> lineOfAction(const Wrench& wrench, double min_force) {
  if (!isFinite(wrench)) {
    return Failure{"the wrench is not finite; check the sensor and its driver"};
  }
  const double force = wrench.force.norm();
  if (!(force >= min_force)) {
    std::ostringstream reason;
    reason << "a force of " << force << " N is below " << min_force
           << " N: its line would be all noise; press harder";
    return Failure{reason.str()};
  }
  LineOfAction line;
  line.force = force;
  line.direction = wrench.force / force;
  line.point = line.direction.cross(wrench.torque / force);
  line.pitch = line.direction.dot(wrench.torque / force);
  return line;
}

LineOfAction transformLine(const Pose& T_a_b, const LineOfAction& line_b) {
  LineOfAction line_a = line_b;
  line_a.point = T_a_b * line_b.point;
  line_a.direction = T_a_b.linear() * line_b.direction;
  return line_a;
}

}  // namespace smore
