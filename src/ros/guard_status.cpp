// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/guard_status.h"

namespace smore {

void compose(const GuardReport& now, Status* status) {
  if (!now.fault.empty()) {
    status->summary(Status::ERROR, "stopped: " + now.fault);
  } else if (now.moving && !now.lateness.empty()) {
    status->summary(Status::WARN, "the motion waits: " + now.lateness);
  } else if (now.moving) {
    status->summary(Status::OK, "the robot moves");
  } else {
    status->summary(Status::OK, "the robot may move");
  }
  status->add("fault", now.fault);
  status->add("waits for", now.lateness);
  status->add("in motion", now.moving);
  status->add("ceiling of the force [N]", now.max_force);
  status->add("ceiling of the torque [N m]", now.max_torque);
}

}  // namespace smore
