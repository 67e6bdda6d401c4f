// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/tool_gap.h"

#include <iomanip>
#include <sstream>

namespace smore {

std::string toolGapProblem(const Pose& T_tool_seen, const ToolGapLimits& limits,
                           const std::string& description) {
  const Vec3& offset = T_tool_seen.translation();
  const double turn = angleBetween(Pose::Identity(), T_tool_seen);
  if (offset.norm() <= limits.distance && turn <= limits.angle) return "";
  std::ostringstream problem;
  problem << std::fixed << std::setprecision(4) << "tf has the tool " << offset.norm()
          << " m from where the joints and the arm's description (" << description << ") have it: ("
          << offset.x() << ", " << offset.y() << ", " << offset.z()
          << ") m in the tool's axes, and turned by " << turn << " rad; allowed are "
          << limits.distance << " m and " << limits.angle
          << " rad. If that is the TCP set on the pendant, set it to zero: wrenches come wrong "
             "with it. Else see that the robot: and the robot_base: of the task are those of the "
             "arm, and give its calibrated robot_description";
  return problem.str();
}

}  // namespace smore
