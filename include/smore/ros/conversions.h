// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Wrench.h>
#include <nav_msgs/Path.h>
#include <trajectory_msgs/JointTrajectory.h>

#include <string>
#include <vector>

#include "smore/common/geometry.h"
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

/// Names of the Cartesian robot's joints in their order from the world to the hand: prismatic along
/// x, y and z, then revolute about z (yaw), y (pitch) and x (roll).
const std::vector<std::string>& cartesianJointNames();

/// Joint positions of the Cartesian robot at a pose, in the order of the names [m, rad].
std::vector<double> toCartesianJoints(const Pose& T_world_object);
/// Pose of six joint positions in the order of the names [m, rad].
Pose fromCartesianJoints(const std::vector<double>& positions);

/// The command that moves the Cartesian robot along `path`; points are timed by the given speeds
/// [m/s, rad/s], the first at 0. An empty path is the command to stop.
trajectory_msgs::JointTrajectory toTrajectory(const Path& path, double linear_speed,
                                              double angular_speed);
/// The path of a command, its joints in any order. A failure for unknown, missing or double joints
/// and for positions that are not finite. No points: an empty path.
Result<Path> fromTrajectory(const trajectory_msgs::JointTrajectory& message);

}  // namespace smore
