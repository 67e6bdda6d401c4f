// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Wrench.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/JointState.h>
#include <trajectory_msgs/JointTrajectory.h>

#include <cstdint>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/joint_trajectory.h"
#include "smore/common/result.h"
#include "smore/contact/contact_observation.h"
#include "smore/ros/messages.h"

namespace smore {

/// Names of the two frames that everything is given in.
struct FrameNames {
  std::string world = "world";
  std::string object = "object";
};

geometry_msgs::Pose toMessage(const Pose& pose);
geometry_msgs::Wrench toMessage(const Wrench& wrench);
/// Pose as the transform of a child frame in its parent.
geometry_msgs::Transform toTransform(const Pose& pose);
/// `frames.world` is the frame of the pose, `frames.object` that of the line.
smore_msgs::ContactObservation toMessage(const ContactObservation& observation,
                                         const FrameNames& frames);
/// Poses in `frame`, all stamped with `time` [s].
nav_msgs::Path toMessage(const Path& path, const std::string& frame, double time);

/// A failure for numbers that are not finite and for quaternions that are not of unit length to 1
/// %; within that they are normalised.
Result<Pose> fromMessage(const geometry_msgs::Pose& message);
Result<Pose> fromTransform(const geometry_msgs::Transform& message);
/// As fromMessage; a failure for another frame than `frame` too.
Result<Pose> fromMessage(const geometry_msgs::PoseStamped& message, const std::string& frame);
/// Values as they are; the caller checks with isFinite.
Wrench fromMessage(const geometry_msgs::Wrench& message);
/// A failure for values that are not finite, unknown states, directions not of unit length.
Result<ContactObservation> fromMessage(const smore_msgs::ContactObservation& message);
Result<Path> fromMessage(const nav_msgs::Path& message);

trajectory_msgs::JointTrajectory toMessage(const JointTrajectory& trajectory);
/// Values as they are; who follows the trajectory checks them.
JointTrajectory fromMessage(const trajectory_msgs::JointTrajectory& message);

/// Positions of the joints `names` in this order. A failure where one is missing or not finite;
/// other joints (a gripper's) may be among them.
Result<std::vector<double>> fromMessage(const sensor_msgs::JointState& message,
                                        const std::vector<std::string>& names);

/// A count of a message, or the largest that an int holds: whoever asks for no limit asks for more.
int countOf(std::uint32_t count);

}  // namespace smore
