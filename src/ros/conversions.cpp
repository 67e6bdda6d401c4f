// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/conversions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace smore {
namespace {

// Beyond this a quaternion is taken for an error, not for rounding.
constexpr double kUnitTolerance = 0.01;
constexpr double kRounding = 1e-9;

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
  if (position.cwiseAbs().maxCoeff() > kFarthestPlace) {
    return Failure{"the pose is more than 10 km from the origin; check the frame and its units"};
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
  // Not one that is of unit length but for rounding: copies of it stay the same to the bit.
  if (std::abs(line.direction.norm() - 1.0) > kRounding) line.direction.normalize();
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

trajectory_msgs::JointTrajectory toMessage(const JointTrajectory& trajectory) {
  trajectory_msgs::JointTrajectory message;
  message.joint_names = trajectory.joint_names;
  for (const JointTrajectoryPoint& point : trajectory.points) {
    trajectory_msgs::JointTrajectoryPoint sent;
    sent.positions = point.positions;
    sent.velocities = point.velocities;
    sent.time_from_start = ros::Duration(point.time);
    message.points.push_back(sent);
  }
  return message;
}

JointTrajectory fromMessage(const trajectory_msgs::JointTrajectory& message) {
  JointTrajectory trajectory;
  trajectory.joint_names = message.joint_names;
  for (const trajectory_msgs::JointTrajectoryPoint& point : message.points) {
    trajectory.points.push_back({point.time_from_start.toSec(), point.positions, point.velocities});
  }
  return trajectory;
}

Result<std::vector<double>> fromMessage(const sensor_msgs::JointState& message,
                                        const std::vector<std::string>& names) {
  std::vector<double> positions;
  for (const std::string& name : names) {
    const auto place = std::find(message.name.begin(), message.name.end(), name);
    const auto index = static_cast<size_t>(place - message.name.begin());
    if (place == message.name.end() || index >= message.position.size()) {
      return Failure{"no position of joint '" + name + "' among the joint states"};
    }
    if (!std::isfinite(message.position[index])) {
      return Failure{"the position of joint '" + name + "' is not finite"};
    }
    positions.push_back(message.position[index]);
  }
  return positions;
}

int countOf(std::uint32_t count) {
  return static_cast<int>(std::min<std::uint32_t>(count, std::numeric_limits<int>::max()));
}

}  // namespace smore
