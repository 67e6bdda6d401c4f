// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/kinematic_tree.h"

#include <algorithm>

#include "smore/common/result.h"

namespace smore {
namespace {

Pose jointMotion(const TreeLink& link, double position) {
  Pose motion = Pose::Identity();
  if (link.prismatic) {
    motion.translation() = position * link.axis;
  } else {
    motion.linear() = Eigen::AngleAxisd(position, link.axis).toRotationMatrix();
  }
  return motion;
}

}  // namespace

KinematicTree::KinematicTree(const UrdfModel& model, const std::string& root)
    : source_(model.source) {
  const auto link = model->getLink(root);
  if (!link) throw InputError(source_ + ": there is no link '" + root + "'");
  add(model, *link, -1);
}

void KinematicTree::add(const UrdfModel& model, const urdf::Link& link, int parent) {
  TreeLink node;
  node.name = link.name;
  node.parent = parent;
  if (parent >= 0) readJoint(*link.parent_joint, &node);
  const int index = static_cast<int>(links_.size());
  links_.push_back(node);
  for (const auto& child : link.child_links) add(model, *child, index);
}

void KinematicTree::readJoint(const urdf::Joint& joint, TreeLink* link) {
  link->T_parent_joint = toPose(joint.parent_to_joint_origin_transform);
  if (joint.type == urdf::Joint::FIXED) return;
  link->prismatic = joint.type == urdf::Joint::PRISMATIC;
  if (!link->prismatic && joint.type != urdf::Joint::REVOLUTE &&
      joint.type != urdf::Joint::CONTINUOUS) {
    throw InputError(source_ + ": joint " + joint.name +
                     ": only fixed, revolute, continuous and prismatic joints are known");
  }
  link->axis = Vec3(joint.axis.x, joint.axis.y, joint.axis.z).normalized();
  link->variable = variableOf(joint.mimic ? joint.mimic->joint_name : joint.name);
  if (!joint.mimic) return;
  link->multiplier = joint.mimic->multiplier;
  link->offset = joint.mimic->offset;
}

// A joint may be mimicked before its own link is reached.
int KinematicTree::variableOf(const std::string& joint) {
  const auto known = std::find(joint_names_.begin(), joint_names_.end(), joint);
  const auto index = static_cast<int>(known - joint_names_.begin());
  if (known == joint_names_.end()) joint_names_.push_back(joint);
  return index;
}

int KinematicTree::linkIndex(const std::string& name) const {
  const auto found = std::find_if(links_.begin(), links_.end(),
                                  [&name](const TreeLink& link) { return link.name == name; });
  if (found == links_.end()) {
    throw InputError(source_ + ": there is no link '" + name + "' below " + links_.front().name);
  }
  return static_cast<int>(found - links_.begin());
}

std::vector<Pose> KinematicTree::linkPoses(const std::vector<double>& positions) const {
  std::vector<Pose> poses(links_.size(), Pose::Identity());
  for (size_t i = 1; i < links_.size(); ++i) {
    const TreeLink& link = links_[i];
    poses[i] = poses[static_cast<size_t>(link.parent)] * link.T_parent_joint;
    if (link.variable < 0) continue;
    const double variable = positions[static_cast<size_t>(link.variable)];
    poses[i] = poses[i] * jointMotion(link, link.multiplier * variable + link.offset);
  }
  return poses;
}

}  // namespace smore
