// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/kinematics/kinematic_tree.h"

namespace smore {

constexpr int kArmJoints = 6;

/// Positions [rad] or velocities [rad/s] of the arm's joints, from base to tool.
using JointVector = Eigen::Matrix<double, kArmJoints, 1>;

/// Velocity of the tool frame's origin [m/s] over its angular velocity [rad/s], in the axes of the
/// base, per joint velocity.
using ArmJacobian = Eigen::Matrix<double, 6, kArmJoints>;

/// What a joint can do.
struct JointLimits {
  double min = 0.0;       ///< [rad]
  double max = 0.0;       ///< [rad]
  double velocity = 0.0;  ///< [rad/s]
  double effort = 0.0;    ///< [N m]
};

/// Names of an arm's frames in its URDF; the defaults are those of Universal Robots' driver.
struct ArmFrames {
  std::string base = "base_link";
  std::string tool = "tool0_controller";  ///< frame of the wrist sensor
  std::string grasp = "grasp_frame";      ///< where the gripper holds things
};

/// An arm of six turning joints: forward kinematics and Jacobian. Joints beyond the tool (the
/// gripper's) stand at 0, which is open.
class ArmModel {
 public:
  /// InputError where the chain from base to tool has not six turning joints, or one without
  /// limits.
  explicit ArmModel(const UrdfModel& urdf, const ArmFrames& frames = {});

  const ArmFrames& frames() const { return frames_; }
  const std::array<std::string, kArmJoints>& jointNames() const { return joint_names_; }
  const std::array<JointLimits, kArmJoints>& limits() const { return limits_; }
  const KinematicTree& tree() const { return tree_; }

  /// Number of the joint that moves the link last, from 1; 0 for what stands with the base.
  int jointCountBefore(int link) const { return joints_before_[static_cast<size_t>(link)]; }

  /// T_base_link of each link of the tree.
  std::vector<Pose> linkPoses(const JointVector& q) const;

  /// T_base_tool.
  Pose toolPose(const JointVector& q) const;

  ArmJacobian jacobian(const JointVector& q) const;

  /// A point [m] on each joint's axis and its direction, in the base frame.
  struct Axis {
    Vec3 point;
    Vec3 direction;
  };
  std::array<Axis, kArmJoints> axes(const JointVector& q) const;

  /// Pose of the grasp frame in the tool frame.
  const Pose& T_tool_grasp() const { return T_tool_grasp_; }

 private:
  std::array<Axis, kArmJoints> axesAt(const std::vector<Pose>& poses) const;

  ArmFrames frames_;
  KinematicTree tree_;
  int tool_ = 0;                             ///< link of the tool frame
  std::array<int, kArmJoints> joint_links_;  ///< the link that each joint carries
  std::vector<int> joints_before_;
  std::array<std::string, kArmJoints> joint_names_;
  std::array<JointLimits, kArmJoints> limits_;
  Pose T_tool_grasp_ = Pose::Identity();
};

/// The joint vector as a list, in the same order.
std::vector<double> toList(const JointVector& q);

/// InputError where there are not six values or one is not finite.
JointVector toJointVector(const std::vector<double>& values);

}  // namespace smore
