// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/parameters.h"
#include "smore/contact/motion_guard.h"
#include "smore/kinematics/motion_horizon.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// Below these no robot could work [N], [N m], [rad/s].
constexpr MotionLimits kLeastLimits{1.0, 0.1, 0.01};

/// How the guard node works; config/guard.yaml explains each.
struct GuardParameters {
  MotionGuardParameters guard;
  HorizonParameters horizon;
  bool sets_force = false;   ///< whether `max_force` was given
  bool sets_torque = false;  ///< whether `max_torque` was given
};

/// Errors are noted in `reader`.
GuardParameters readGuardParameters(ParameterReader* reader);

/// What follows from the sensor: its noise tells whether it is frozen, and ceilings that were not
/// given stay within eight tenths of its range.
void fitToSensor(const Scenario& scenario, GuardParameters* parameters);

}  // namespace smore
