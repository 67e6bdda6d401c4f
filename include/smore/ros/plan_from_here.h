// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>

#include "smore/common/result.h"

namespace smore {

/// Asks the planner for a way from where the object is to `goal`, T_world_object, and so shows it;
/// nothing moves. The probability that it touches, or why there is no way. `node`: in the namespace
/// of the nodes. Waits for the listener, 2 s at most, and for the plan.
Result<double> planFromHere(const ros::NodeHandle& node, const geometry_msgs::PoseStamped& goal);

}  // namespace smore
