// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "smore/scenario/scenario.h"

namespace smore {

/// What a force/torque sensor can measure on each axis, in plus and minus.
struct WrenchRange {
  double force = std::numeric_limits<double>::infinity();   ///< [N], positive
  double torque = std::numeric_limits<double>::infinity();  ///< [N m], positive
};

/// Of the sensor in an arm's wrist, from the technical specifications of Universal Robots'
/// e-Series. Without end for the Cartesian robot, which has none, and arms of another make, whose
/// sensor nobody has told: the guard's ceilings must be set for them.
WrenchRange wristSensorRange(RobotKind kind);

}  // namespace smore
