// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

#include "smore/ros/ros_robot.h"

namespace smore {

/// Tilts what the robot holds by `tilt` [rad] about two horizontal axes, to and fro (payloadTilts),
/// stands still at each pose, comes back, and has the listener identify the payload. The robot must
/// be ready and free of contact. A touch ends it, with the robot back where it was. Why it failed,
/// else empty.
std::string identifyPayloadByTilting(RosRobot* robot, ros::NodeHandle* node, double tilt);

}  // namespace smore
