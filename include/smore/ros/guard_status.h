// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/ros/status_publisher.h"

namespace smore {

/// What the guard knows of the robot.
struct GuardReport {
  std::string fault;        ///< why it may not move; empty: it may
  std::string lateness;     ///< what a motion would wait for; empty: nothing
  bool moving = false;      ///< whether a motion is handed to the robot
  double max_force = 0.0;   ///< ceiling of the raw wrench [N]
  double max_torque = 0.0;  ///< the same [N m]
};

/// The guard's status `motion`: ERROR with the fault, WARN while a motion waits and for what.
void compose(const GuardReport& now, Status* status);

}  // namespace smore
