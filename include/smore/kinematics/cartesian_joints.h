// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/joint_trajectory.h"
#include "smore/common/result.h"

namespace smore {

/// Names of the Cartesian robot's joints in their order from the world to the hand: prismatic along
/// x, y and z, then revolute about z (yaw), y (pitch) and x (roll).
const std::vector<std::string>& cartesianJointNames();

/// Joint positions of the Cartesian robot at a pose, in the order of the names [m, rad].
std::vector<double> toCartesianJoints(const Pose& T_world_object);

/// Pose of six joint positions in the order of the names [m, rad].
Pose fromCartesianJoints(const std::vector<double>& positions);

/// The joint motion of the Cartesian robot along `path`; points are timed by the given speeds [m/s,
/// rad/s], the first at 0. No points for an empty path.
JointTrajectory cartesianTrajectory(const Path& path, double linear_speed, double angular_speed);

/// The poses of a joint motion of the Cartesian robot, its joints in any order. A failure for
/// unknown, missing or repeated joints and for positions that are not finite. No points: an empty
/// path.
Result<Path> cartesianPath(const JointTrajectory& trajectory);

}  // namespace smore
