// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "smore/kinematics/arm_model.h"

namespace smore {

/// Lengths of an arm built as those of Universal Robots [m]: the axes of joints 2, 3 and 4
/// parallel, those of 1, 5 and 6 each square to its neighbour. Denavit and Hartenberg's parameters,
/// with the signs of the maker's table.
struct UrGeometry {
  double d1 = 0.0;
  double a2 = 0.0;
  double a3 = 0.0;
  double d4 = 0.0;
  double d5 = 0.0;
  double d6 = 0.0;
  Pose T_base_first = Pose::Identity();  ///< frame 0 of the table in the arm's base frame
  Pose T_sixth_tool = Pose::Identity();  ///< tool frame in frame 6 of the table
};

/// The geometry of an arm whose joint positions are those of the table; nothing where its axes are
/// not as above to 0.02 (a calibrated arm's differ by some thousandths).
std::optional<UrGeometry> urGeometry(const ArmModel& arm);

/// Up to eight configurations with the tool at a pose, each joint in [-pi, pi], in closed form:
/// exact for the geometry above, near to exact for a calibrated arm. Empty where the pose is out of
/// reach. Where the axes of joints 4 and 6 are parallel, joint 6 is 0.
std::vector<JointVector> urBranches(const UrGeometry& arm, const Pose& T_base_tool);

}  // namespace smore
