// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

#include <string>
#include <vector>

#include "smore/kinematics/arm_motion.h"
#include "smore/ros/conversions.h"

namespace smore {

/// T_parent_child as a message.
geometry_msgs::TransformStamped stampedTransform(const std::string& parent,
                                                 const std::string& child,
                                                 const Pose& T_parent_child,
                                                 const ros::Time& stamp);

/// What no driver of an arm can know: where the arm stands (its base in the world) and how the
/// gripper holds the object (the object in the frame of the wrist sensor).
std::vector<geometry_msgs::TransformStamped> gripTransforms(const ArmMotion& arm,
                                                            const Pose& T_world_base,
                                                            const FrameNames& frames);

}  // namespace smore
