// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <memory>
#include <string>
#include <vector>

#include "bullet_shapes.h"
#include "smore/kinematics/kinematic_tree.h"
#include "smore/simulation/mass_properties.h"

namespace smore {

/// The mass of a link and its inertia, in the link's frame; nothing where the URDF gives none.
MassProperties massOf(const urdf::Link& link);

/// A URDF as a multi-body of Bullet with a fixed base, one body for all links that are rigidly
/// joined, and a motor in each joint that drives it to a position and a velocity within the joint's
/// limits of speed and effort. Positions keep within the joint's limits.
class UrdfMultibody {
 public:
  /// The links from `root` on, without those beyond `last` (which stays). `step` [s] of the
  /// simulation. InputError where a moving part has no mass or the URDF has mimic joints among
  /// them.
  UrdfMultibody(const UrdfModel& urdf, const std::string& root, const std::string& last,
                const Pose& T_world_root, double step);

  /// Adds body, motors, limits, and colliders of a collision group with those of `mask`, to a
  /// world, from which `removeFrom` takes them.
  void addTo(btMultiBodyDynamicsWorld* world, int group, int mask);
  void removeFrom(btMultiBodyDynamicsWorld* world);

  /// Joints of the bodies, in the order of all vectors here.
  const std::vector<std::string>& jointNames() const { return joint_names_; }

  /// Sets the joints, at rest.
  void place(const std::vector<double>& positions);

  /// What the motors drive to in the next step.
  void setTarget(const std::vector<double>& positions, const std::vector<double>& velocities);

  std::vector<double> positions() const;
  std::vector<double> velocities() const;

  /// Adds a wrench on `last`, at the origin of its frame and in the axes of the world, for the next
  /// step.
  void applyWrench(const Wrench& wrench_world);

  /// T_world_last.
  Pose lastPose() const;

  /// The body's collider that holds a link, and the name of the link that a shape belongs to.
  const std::string& linkName(const btCollisionObject* collider, int shape) const;

  btMultiBodyLinkCollider* lastCollider() { return parts_.back().collider.get(); }
  /// Of the part that carries the last one.
  const btCollisionObject* colliderBeforeLast() const {
    return parts_[static_cast<size_t>(parts_.back().parent)].collider.get();
  }
  const btCollisionObject* baseCollider() const { return parts_.front().collider.get(); }

 private:
  /// Links that are rigidly joined.
  struct Part {
    int parent = -1;      ///< index of the part that carries it
    int joint_link = 0;   ///< link of the tree that its joint carries
    Pose T_parent_joint;  ///< from the frame of the parent part to that of this, at 0
    std::vector<MassProperties> masses;
    MassProperties mass;  ///< in the frame of the part: that of the link of its joint
    Pose T_part_body;     ///< centre of mass and principal axes
    std::vector<Shape> shapes;
    std::vector<std::string> names;
    std::unique_ptr<BulletCompound> compound;
    std::unique_ptr<btMultiBodyLinkCollider> collider;
  };

  void collectParts(const UrdfModel& urdf, const KinematicTree& tree, int last);
  void addLink(const UrdfModel& urdf, const TreeLink& link, const Pose& T_part_link, Part* part);
  void buildBody(const KinematicTree& tree, const Pose& T_world_root);
  void addJoint(const TreeLink& link, int index);
  void addCollider(int index);
  void addMotor(const urdf::Joint& joint, int index, double step);
  void updateColliders();

  std::string source_;       ///< of the URDF, for messages
  std::vector<Part> parts_;  ///< the base first; part i is link i - 1 of the multi-body
  Pose T_part_last_ = Pose::Identity();
  std::vector<std::string> joint_names_;
  std::unique_ptr<btMultiBody> body_;
  std::vector<std::unique_ptr<btMultiBodyJointMotor>> motors_;
  std::vector<std::unique_ptr<btMultiBodyJointLimitConstraint>> limits_;
};

}  // namespace smore
