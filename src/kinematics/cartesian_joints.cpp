// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/cartesian_joints.h"

#include <algorithm>

namespace smore {
namespace {

// For each Cartesian joint its place in the trajectory's list of names.
Result<std::vector<size_t>> jointOrder(const std::vector<std::string>& names) {
  std::vector<size_t> order;
  for (const std::string& joint : cartesianJointNames()) {
    if (std::count(names.begin(), names.end(), joint) != 1) {
      return Failure{"a command must name joint '" + joint + "' once"};
    }
    order.push_back(std::find(names.begin(), names.end(), joint) - names.begin());
  }
  if (names.size() != order.size()) return Failure{"a command names unknown joints"};
  return order;
}

}  // namespace

const std::vector<std::string>& cartesianJointNames() {
  static const std::vector<std::string> names = {"x_joint",   "y_joint",     "z_joint",
                                                 "yaw_joint", "pitch_joint", "roll_joint"};
  return names;
}

std::vector<double> toCartesianJoints(const Pose& T_world_object) {
  const Vec3 position = T_world_object.translation();
  const Vec3 angles = rollPitchYaw(T_world_object);
  return {position.x(), position.y(), position.z(), angles.z(), angles.y(), angles.x()};
}

Pose fromCartesianJoints(const std::vector<double>& positions) {
  return makePose({positions.at(0), positions.at(1), positions.at(2)},
                  {positions.at(5), positions.at(4), positions.at(3)});
}

JointTrajectory cartesianTrajectory(const Path& path, double linear_speed, double angular_speed) {
  JointTrajectory trajectory;
  trajectory.joint_names = cartesianJointNames();
  double time = 0.0;
  for (size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      time += std::max(distanceBetween(path[i - 1], path[i]) / linear_speed,
                       angleBetween(path[i - 1], path[i]) / angular_speed);
    }
    trajectory.points.push_back({time, toCartesianJoints(path[i]), {}});
  }
  return trajectory;
}

Result<Path> cartesianPath(const JointTrajectory& trajectory) {
  Path path;
  if (trajectory.points.empty()) return path;
  const Result<std::vector<size_t>> order = jointOrder(trajectory.joint_names);
  if (!order) return Failure{order.reason()};
  for (const JointTrajectoryPoint& point : trajectory.points) {
    if (point.positions.size() != order->size()) {
      return Failure{"a point of the command has not one position for each joint"};
    }
    std::vector<double> positions;
    for (const size_t place : *order) positions.push_back(point.positions[place]);
    path.push_back(fromCartesianJoints(positions));
    if (!isFinite(path.back())) return Failure{"a position of the command is not finite"};
  }
  return path;
}

}  // namespace smore
