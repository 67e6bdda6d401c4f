// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/arm_model.h"

#include <algorithm>

#include "smore/common/result.h"

namespace smore {
namespace {

// Links of moving joints on the way from the root to `tool`.
std::vector<int> movingLinks(const KinematicTree& tree, int tool) {
  std::vector<int> moving;
  for (int link = tool; link >= 0; link = tree.links()[static_cast<size_t>(link)].parent) {
    if (tree.links()[static_cast<size_t>(link)].variable >= 0) moving.push_back(link);
  }
  std::reverse(moving.begin(), moving.end());
  return moving;
}

// Its name is that of the joint that moves, also where another one mimics that.
void refuseMimic(const urdf::Joint& joint, const std::string& source) {
  if (!joint.mimic) return;
  throw InputError(source + ": joint " + joint.name + ": mimics " + joint.mimic->joint_name +
                   "; the arm's six joints must move by themselves");
}

JointLimits limitsOf(const urdf::Joint& joint, const std::string& source) {
  if (joint.type != urdf::Joint::REVOLUTE || !joint.limits || joint.limits->velocity <= 0.0 ||
      joint.limits->upper <= joint.limits->lower) {
    throw InputError(source + ": joint " + joint.name +
                     ": the arm needs revolute joints (not continuous ones) with limits of "
                     "position and velocity; give it <limit lower upper velocity effort>");
  }
  return {joint.limits->lower, joint.limits->upper, joint.limits->velocity, joint.limits->effort};
}

}  // namespace

ArmModel::ArmModel(const UrdfModel& urdf, const ArmFrames& frames)
    : frames_(frames), tree_(urdf, frames.base), tool_(tree_.linkIndex(frames.tool)) {
  const std::vector<int> moving = movingLinks(tree_, tool_);
  if (moving.size() != kArmJoints) {
    throw InputError(urdf.source + ": there are " + std::to_string(moving.size()) +
                     " moving joints from " + frames.base + " to " + frames.tool +
                     ", but the arm must have " + std::to_string(kArmJoints));
  }
  std::copy(moving.begin(), moving.end(), joint_links_.begin());
  for (size_t i = 0; i < kArmJoints; ++i) {
    const TreeLink& link = tree_.links()[static_cast<size_t>(joint_links_[i])];
    refuseMimic(*urdf->getLink(link.name)->parent_joint, urdf.source);
    joint_names_[i] = tree_.jointNames()[static_cast<size_t>(link.variable)];
    limits_[i] = limitsOf(*urdf->getJoint(joint_names_[i]), urdf.source);
  }
  for (size_t i = 0; i < tree_.links().size(); ++i) {
    const int parent = tree_.links()[i].parent;
    const bool carried =
        std::find(moving.begin(), moving.end(), static_cast<int>(i)) != moving.end();
    joints_before_.push_back((parent < 0 ? 0 : joints_before_[static_cast<size_t>(parent)]) +
                             (carried ? 1 : 0));
  }
  const std::vector<Pose> poses = linkPoses(JointVector::Zero());
  T_tool_grasp_ = poses[static_cast<size_t>(tool_)].inverse() *
                  poses[static_cast<size_t>(tree_.linkIndex(frames.grasp))];
}

std::vector<Pose> ArmModel::linkPoses(const JointVector& q) const {
  std::vector<double> positions(tree_.jointNames().size(), 0.0);
  for (size_t i = 0; i < kArmJoints; ++i) {
    const TreeLink& link = tree_.links()[static_cast<size_t>(joint_links_[i])];
    positions[static_cast<size_t>(link.variable)] = q[static_cast<Eigen::Index>(i)];
  }
  return tree_.linkPoses(positions);
}

Pose ArmModel::toolPose(const JointVector& q) const {
  return linkPoses(q)[static_cast<size_t>(tool_)];
}

std::array<ArmModel::Axis, kArmJoints> ArmModel::axes(const JointVector& q) const {
  return axesAt(linkPoses(q));
}

// A turn about the axis moves neither the axis nor the link's origin on it.
std::array<ArmModel::Axis, kArmJoints> ArmModel::axesAt(const std::vector<Pose>& poses) const {
  std::array<Axis, kArmJoints> axes;
  for (size_t i = 0; i < kArmJoints; ++i) {
    const auto link = static_cast<size_t>(joint_links_[i]);
    axes[i] = {poses[link].translation(), poses[link].linear() * tree_.links()[link].axis};
  }
  return axes;
}

ArmJacobian ArmModel::jacobian(const JointVector& q) const {
  const std::vector<Pose> poses = linkPoses(q);
  const Vec3 tool = poses[static_cast<size_t>(tool_)].translation();
  const auto axes = axesAt(poses);
  ArmJacobian jacobian;
  for (Eigen::Index i = 0; i < kArmJoints; ++i) {
    const Axis& axis = axes[static_cast<size_t>(i)];
    jacobian.col(i) << axis.direction.cross(tool - axis.point), axis.direction;
  }
  return jacobian;
}

std::vector<double> toList(const JointVector& q) { return {q.data(), q.data() + q.size()}; }

JointVector toJointVector(const std::vector<double>& values) {
  const bool finite =
      std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (values.size() != kArmJoints || !finite) {
    throw InputError("joint values must be " + std::to_string(kArmJoints) + " finite numbers");
  }
  return Eigen::Map<const JointVector>(values.data());
}

}  // namespace smore
