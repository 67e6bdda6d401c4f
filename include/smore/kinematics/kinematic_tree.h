// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/kinematics/urdf_model.h"

namespace smore {

/// A link and the joint that carries it: T_parent_link = T_parent_joint J(multiplier q + offset),
/// q the variable of the joint (that of another joint where it mimics one).
struct TreeLink {
  std::string name;
  int parent = -1;  ///< index of the parent link; -1 for the root
  Pose T_parent_joint = Pose::Identity();
  Vec3 axis = Vec3::UnitX();  ///< unit vector in the frames of joint and link
  bool prismatic = false;     ///< else the joint turns
  int variable = -1;          ///< index of the joint's variable; -1 for a fixed joint
  double multiplier = 1.0;
  double offset = 0.0;  ///< [rad] or [m]
};

/// Forward kinematics of a URDF: a chain of rigid transforms, so that no library is needed for it.
class KinematicTree {
 public:
  /// The links of `model` below and with `root`. InputError for a joint that is not fixed,
  /// revolute, continuous or prismatic, and for an unknown root.
  KinematicTree(const UrdfModel& model, const std::string& root);

  /// Parents before their children.
  const std::vector<TreeLink>& links() const { return links_; }

  /// Names of the joints that move by themselves: the order of the variables.
  const std::vector<std::string>& jointNames() const { return joint_names_; }

  /// Index of a link; InputError where there is none of this name.
  int linkIndex(const std::string& name) const;

  /// T_root_link for each link at `positions` of the variables.
  std::vector<Pose> linkPoses(const std::vector<double>& positions) const;

 private:
  void add(const UrdfModel& model, const urdf::Link& link, int parent);
  int variableOf(const std::string& joint);
  void readJoint(const urdf::Joint& joint, TreeLink* link);

  std::string source_;
  std::vector<TreeLink> links_;
  std::vector<std::string> joint_names_;
};

}  // namespace smore
