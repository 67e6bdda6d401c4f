// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

#include <string>

#include "smore/kinematics/arm_motion.h"
#include "smore/ros/conversions.h"

namespace smore {

/// T_parent_child as a message.
geometry_msgs::TransformStamped stampedTransform(const std::string& parent,
                                                 const std::string& child,
                                                 const Pose& T_parent_child,
                                                 const ros::Time& stamp);

/// Where the arm stands, its base in the world: what no driver can know.
geometry_msgs::TransformStamped baseTransform(const ArmMotion& arm, const Pose& T_world_base,
                                              const FrameNames& frames);

/// How the gripper holds the object, in the frame of the wrist sensor: what no driver can know.
geometry_msgs::TransformStamped gripTransform(const ArmMotion& arm, const FrameNames& frames);

}  // namespace smore
