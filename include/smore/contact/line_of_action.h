// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"
#include "smore/common/result.h"

namespace smore {

/// The line in space on which a single point contact must lie, from one wrench (paper, equation 2).
struct LineOfAction {
  Vec3 point = Vec3::Zero();       ///< the point of the line nearest to the frame's origin [m]
  Vec3 direction = Vec3::UnitX();  ///< unit vector along the force on the object
  double force = 0.0;              ///< magnitude of the force [N]
  double pitch = 0.0;             ///< moment about the line over force [m]; 0 for one point contact
  double direction_stddev = 0.0;  ///< standard deviation of the direction, per axis [rad]
  double offset_stddev = 0.0;     ///< standard deviation of the point across the line, per axis [m]
};

/// Whether all numbers of the line are.
bool isFinite(const LineOfAction& line);

/// Point r = F x M / F.F, direction F / |F| and pitch h = F.M / F.F of `wrench`, in its frame.
/// No line for a force that is not finite or below `min_force` [N] (positive): the point's error
/// grows as the torque's error over the force.
Result<LineOfAction> lineOfAction(const Wrench& wrench, double min_force);

/// The same line in frame a, from frame b. The point stays the one nearest to frame b's origin.
LineOfAction transformLine(const Pose& T_a_b, const LineOfAction& line_b);

}  // namespace smore
