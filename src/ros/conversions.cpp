// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/conversions.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// Beyond this a quaternion is taken for an error, not for rounding.
constexpr double kUnitTolerance = 0.01;

template <typename Message>
Message toXyz(const Vec3& vector) {
  Message message;
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
  return message;
}

template <typename Message>
Vec3 fromXyz(const Message& message) {
  return {message.x, message.y, message.z};
}

geometry_msgs::Quaternion toQuaternion(const Pose& pose) {
  const Eigen::Quaterniond rotation(pose.linear());
  geometry_msgs::Quaternion message;
  message.x = rotation.x();
  message.y = rotation.y();
  message.z = rotation.z();
  message.w = rotation.w();
  return message;
}

Result<Pose> makeChecked(const Vec3& position, const geometry_msgs::Quaternion& orientation) {
  const Eigen::Quaterniond rotation(orientation.w, orientation.x, orientation.y, orientation.z);
  if (!position.allFinite() || !rotation.coeffs().allFinite()) {
    return Failure{"the pose is not finite"};
  }
  if (std::abs(rotation.norm() - 1.0) > kUnitTolerance) {
    return Failure{"the pose's quaternion is not of unit length; normalise it"};
  }
  Pose pose = Pose::Identity();
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() = position;
  return pose;
}

smore_msgs::LineOfAction toMessage(const LineOfAction& line) {
  smore_msgs::LineOfAction message;
  message.point = toXyz<geometry_msgs::Vector3>(line.point);
  message.direction = toXyz<geometry_msgs::Vector3>(line.direction);
  message.force = line.force;
  message.pitch = line.pitch;
  message.direction_stddev = line.direction_stddev;
  message.offset_stddev = line.offset_stddev;
  return message;
}

Result<LineOfAction> fromMessage(const smore_msgs::LineOfAction& message) {
  LineOfAction line;
  line.point = fromXyz(message.point);
  line.direction = fromXyz(message.direction);
  line.force = message.force;
  line.pitch = message.pitch;
  line.direction_stddev = message.direction_stddev;
  line.offset_stddev = message.offset_stddev;
  const Eigen::Vector4d scalars(line.force, line.pitch, line.direction_stddev, line.offset_stddev);
  if (!line.point.allFinite() || !line.direction.allFinite() || !scalars.allFinite()) {
    return Failure{"the line of action is not finite"};
  }
  if (std::abs(line.direction.norm() - 1.0) > kUnitTolerance) {
    return Failure{"the line's direction is not of unit length"};
  }
  if (line.force <= 0.0 || line.direction_stddev < 0.0 || line.offset_stddev < 0.0) {
    return Failure{"the line's force must be positive and its deviations not negative"};
  }
  return line;
}

Result<ContactState> stateFromMessage(std::uint8_t state) {
  switch (state) {
    case smore_msgs::ContactObservation::FREE:
      return ContactState::kFree;
    case smore_msgs::ContactObservation::UNSURE:
      return ContactState::kUnsure;
    case smore_msgs::ContactObservation::CONTACT:
      return ContactState::kContact;
    default:
      return Failure{"unknown contact state " + std::to_string(state)};
  }
}

std::uint8_t stateMessage(ContactState state) {
  switch (state) {
    case ContactState::kFree:
      return smore_msgs::ContactObservation::FREE;
    case ContactState::kContact:
      return smore_msgs::ContactObservation::CONTACT;
    case ContactState::kUnsure:
      break;
  }
  return smore_msgs::ContactObservation::UNSURE;
}

Vec3 rollPitchYaw(const Pose& pose) {
  // Rz(yaw) Ry(pitch) Rx(roll); where cos(pitch) vanishes only yaw - roll is defined and roll is 0.
  const Eigen::Matrix3d& R = pose.linear();
  const double cos_pitch = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(-R(2, 0), cos_pitch);
  constexpr double kSingular = 1e-9;
  if (cos_pitch < kSingular) return {0.0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

// For each Cartesian joint its place in the message's list of names.
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

geometry_msgs::Pose toMessage(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position = toXyz<geometry_msgs::Point>(pose.translation());
  message.orientation = toQuaternion(pose);
  return message;
}

geometry_msgs::Wrench toMessage(const Wrench& wrench) {
  geometry_msgs::Wrench message;
  message.force = toXyz<geometry_msgs::Vector3>(wrench.force);
  message.torque = toXyz<geometry_msgs::Vector3>(wrench.torque);
  return message;
}

geometry_msgs::Transform toTransform(const Pose& pose) {
  geometry_msgs::Transform message;
  message.translation = toXyz<geometry_msgs::Vector3>(pose.translation());
  message.rotation = toQuaternion(pose);
  return message;
}

smore_msgs::ContactObservation toMessage(const ContactObservation& observation,
                                         const FrameNames& frames) {
  smore_msgs::ContactObservation message;
  message.header.stamp.fromSec(observation.time);
  message.header.frame_id = frames.object;
  message.world_frame = frames.world;
  message.pose = toMessage(observation.T_world_object);
  message.state = stateMessage(observation.state);
  message.contact_id = static_cast<std::uint32_t>(observation.contact_id);
  message.has_line = observation.line.has_value();
  if (observation.line) message.line = toMessage(*observation.line);
  return message;
}

nav_msgs::Path toMessage(const Path& path, const std::string& frame, double time) {
  nav_msgs::Path message;
  message.header.stamp.fromSec(time);
  message.header.frame_id = frame;
  for (const Pose& pose : path) {
    geometry_msgs::PoseStamped stamped;
    stamped.header = message.header;
    stamped.pose = toMessage(pose);
    message.poses.push_back(stamped);
  }
  return message;
}

Result<Pose> fromMessage(const geometry_msgs::Pose& message) {
  return makeChecked(fromXyz(message.position), message.orientation);
}

Result<Pose> fromTransform(const geometry_msgs::Transform& message) {
  return makeChecked(fromXyz(message.translation), message.rotation);
}

Result<Pose> fromMessage(const geometry_msgs::PoseStamped& message, const std::string& frame) {
  if (message.header.frame_id != frame) {
    return Failure{"the pose is given in frame '" + message.header.frame_id + "'; give it in '" +
                   frame + "'"};
  }
  return fromMessage(message.pose);
}

Wrench fromMessage(const geometry_msgs::Wrench& message) {
  return {fromXyz(message.force), fromXyz(message.torque)};
}

Result<ContactObservation> fromMessage(const smore_msgs::ContactObservation& message) {
  const Result<Pose> pose = fromMessage(message.pose);
  if (!pose) return Failure{pose.reason()};
  const Result<ContactState> state = stateFromMessage(message.state);
  if (!state) return Failure{state.reason()};
  ContactObservation observation;
  observation.time = message.header.stamp.toSec();
  observation.T_world_object = *pose;
  observation.state = *state;
  observation.contact_id = static_cast<int>(message.contact_id);
  if (message.has_line) {
    const Result<LineOfAction> line = fromMessage(message.line);
    if (!line) return Failure{line.reason()};
    observation.line = *line;
  }
  return observation;
}

Result<Path> fromMessage(const nav_msgs::Path& message) {
  Path path;
  for (const geometry_msgs::PoseStamped& stamped : message.poses) {
    const Result<Pose> pose = fromMessage(stamped.pose);
    if (!pose) return Failure{pose.reason()};
    path.push_back(*pose);
  }
  return path;
}

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

trajectory_msgs::JointTrajectory toTrajectory(const Path& path, double linear_speed,
                                              double angular_speed) {
  trajectory_msgs::JointTrajectory message;
  message.joint_names = cartesianJointNames();
  double time = 0.0;
  for (size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      time += std::max(distanceBetween(path[i - 1], path[i]) / linear_speed,
                       angleBetween(path[i - 1], path[i]) / angular_speed);
    }
    trajectory_msgs::JointTrajectoryPoint point;
    point.positions = toCartesianJoints(path[i]);
    point.time_from_start = ros::Duration(time);
    message.points.push_back(point);
  }
  return message;
}

Result<Path> fromTrajectory(const trajectory_msgs::JointTrajectory& message) {
  Path path;
  if (message.points.empty()) return path;
  const Result<std::vector<size_t>> order = jointOrder(message.joint_names);
  if (!order) return Failure{order.reason()};
  for (const trajectory_msgs::JointTrajectoryPoint& point : message.points) {
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
