// SPDX-License-Identifier: BSD-3-Clause
#include "urdf_multibody.h"

#include <algorithm>

#include "smore/common/result.h"

namespace smore {
namespace {

// Share of a position error that a motor takes back in a step.
constexpr double kPositionGain = 0.2;

btQuaternion toBulletRotation(const Eigen::Matrix3d& rotation) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation;
  return toBullet(pose).getRotation();
}

btVector3 principalInertia(const MassProperties& mass, const Pose& T_part_body) {
  const Eigen::Matrix3d& axes = T_part_body.linear();
  return toBullet(Vec3((axes.transpose() * mass.inertia * axes).diagonal()));
}

}  // namespace

MassProperties massOf(const urdf::Link& link) {
  if (!link.inertial) return {};
  const urdf::Inertial& inertial = *link.inertial;
  Eigen::Matrix3d inertia;
  inertia << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy, inertial.iyz,
      inertial.ixz, inertial.iyz, inertial.izz;
  return transformMass(toPose(inertial.origin), {inertial.mass, Vec3::Zero(), inertia});
}

UrdfMultibody::UrdfMultibody(const UrdfModel& urdf, const std::string& root,
                             const std::string& last, const Pose& T_world_root, double step)
    : source_(urdf.source) {
  const KinematicTree tree(urdf, root);
  collectParts(urdf, tree, tree.linkIndex(last));
  buildBody(tree, T_world_root);
  for (size_t i = 1; i < parts_.size(); ++i) {
    addMotor(*urdf->getJoint(joint_names_[i - 1]), static_cast<int>(i) - 1, step);
  }
}

// Goes through the links, parents first: each begins a part of its own or belongs to its parent's.
void UrdfMultibody::collectParts(const UrdfModel& urdf, const KinematicTree& tree, int last) {
  std::vector<int> part_of(tree.links().size(), -1);
  std::vector<Pose> T_part_link(tree.links().size(), Pose::Identity());
  parts_.emplace_back();
  part_of[0] = 0;
  addLink(urdf, tree.links()[0], Pose::Identity(), &parts_[0]);
  for (size_t i = 1; i < tree.links().size(); ++i) {
    const TreeLink& link = tree.links()[i];
    const auto parent = static_cast<size_t>(link.parent);
    if (link.parent == last || part_of[parent] < 0) continue;
    part_of[i] = part_of[parent];
    T_part_link[i] = T_part_link[parent] * link.T_parent_joint;
    if (link.variable >= 0) {
      Part part;
      part.parent = part_of[parent];
      part.joint_link = static_cast<int>(i);
      part.T_parent_joint = T_part_link[i];
      part_of[i] = static_cast<int>(parts_.size());
      T_part_link[i] = Pose::Identity();
      parts_.push_back(std::move(part));
      joint_names_.push_back(tree.jointNames()[static_cast<size_t>(link.variable)]);
    }
    addLink(urdf, link, T_part_link[i], &parts_[static_cast<size_t>(part_of[i])]);
    if (static_cast<int>(i) == last) T_part_last_ = T_part_link[i];
  }
}

void UrdfMultibody::addLink(const UrdfModel& urdf, const TreeLink& link, const Pose& T_part_link,
                            Part* part) {
  const urdf::Link& described = *urdf->getLink(link.name);
  if (described.parent_joint && described.parent_joint->mimic && link.variable >= 0) {
    throw InputError(source_ + ": joint " + described.parent_joint->name +
                     ": mimic joints are known in a gripper beyond the wrist sensor only");
  }
  part->masses.push_back(transformMass(T_part_link, massOf(described)));
  for (Shape shape : collisionShapes(urdf, link.name)) {
    shape.pose = T_part_link * shape.pose;
    part->shapes.push_back(std::move(shape));
    part->names.push_back(link.name);
  }
}

void UrdfMultibody::buildBody(const KinematicTree& tree, const Pose& T_world_root) {
  for (Part& part : parts_) {
    part.mass = joined(part.masses);
    part.T_part_body = principalFrame(part.mass);
  }
  const Part& base = parts_.front();
  body_ = std::make_unique<btMultiBody>(static_cast<int>(parts_.size()) - 1, base.mass.mass,
                                        principalInertia(base.mass, base.T_part_body), true, false);
  body_->setBaseWorldTransform(toBullet(Pose(T_world_root * base.T_part_body)));
  body_->setHasSelfCollision(true);
  body_->setLinearDamping(0.0);
  body_->setAngularDamping(0.0);
  for (size_t i = 1; i < parts_.size(); ++i) {
    addJoint(tree.links()[static_cast<size_t>(parts_[i].joint_link)], static_cast<int>(i) - 1);
  }
  body_->finalizeMultiDof();
  for (int i = -1; i < body_->getNumLinks(); ++i) addCollider(i);
}

// Bullet's links have their frames at the centre of mass, along the principal axes.
void UrdfMultibody::addJoint(const TreeLink& link, int index) {
  const Part& part = parts_[static_cast<size_t>(index) + 1];
  if (part.mass.mass <= 0.0) {
    throw InputError(source_ + ": link " + link.name +
                     ": a moving part needs a mass; add <inertial> to it");
  }
  const Part& parent = parts_[static_cast<size_t>(part.parent)];
  const Pose T_body_joint = parent.T_part_body.inverse() * part.T_parent_joint;
  const Eigen::Matrix3d body_axes = part.T_part_body.linear();
  const Eigen::Matrix3d parent_to_this = (T_body_joint.linear() * body_axes).transpose();
  const btVector3 axis = toBullet(Vec3(body_axes.transpose() * link.axis));
  const btVector3 to_pivot = toBullet(Vec3(T_body_joint.translation()));
  const btVector3 to_center = toBullet(Vec3(body_axes.transpose() * part.mass.center));
  const btVector3 inertia = principalInertia(part.mass, part.T_part_body);
  const auto setup = link.prismatic ? &btMultiBody::setupPrismatic : &btMultiBody::setupRevolute;
  (body_.get()->*setup)(index, part.mass.mass, inertia, part.parent - 1,
                        toBulletRotation(parent_to_this), axis, to_pivot, to_center, true);
}

// Every body has a collider, if need be an empty one: Bullet leaves out the motors of bodies
// without.
void UrdfMultibody::addCollider(int index) {
  Part& part = parts_[static_cast<size_t>(index + 1)];
  part.compound = std::make_unique<BulletCompound>(part.shapes, part.T_part_body.inverse());
  part.collider = std::make_unique<btMultiBodyLinkCollider>(body_.get(), index);
  part.collider->setCollisionShape(part.compound->shape());
  if (index < 0) {
    body_->setBaseCollider(part.collider.get());
  } else {
    body_->getLink(index).m_collider = part.collider.get();
  }
}

void UrdfMultibody::addMotor(const urdf::Joint& joint, int index, double step) {
  if (!joint.limits) {
    throw InputError(source_ + ": joint " + joint.name +
                     ": needs limits; add <limit lower upper velocity effort>");
  }
  const urdf::JointLimits& limits = *joint.limits;
  if (!(limits.effort > 0.0)) {
    throw InputError(source_ + ": joint " + joint.name + ": an effort of " +
                     std::to_string(limits.effort) +
                     " in its limits: a simulated joint would not hold itself; give its largest "
                     "torque or force");
  }
  motors_.push_back(
      std::make_unique<btMultiBodyJointMotor>(body_.get(), index, 0.0, limits.effort * step));
  motors_.back()->setErp(1.0);
  motors_.back()->setRhsClamp(limits.velocity);
  if (joint.type == urdf::Joint::CONTINUOUS) return;
  limits_.push_back(std::make_unique<btMultiBodyJointLimitConstraint>(body_.get(), index,
                                                                      limits.lower, limits.upper));
}

void UrdfMultibody::addTo(btMultiBodyDynamicsWorld* world, int group, int mask) {
  world->addMultiBody(body_.get());
  for (const Part& part : parts_) world->addCollisionObject(part.collider.get(), group, mask);
  for (const auto& motor : motors_) {
    motor->finalizeMultiDof();
    world->addMultiBodyConstraint(motor.get());
  }
  for (const auto& limit : limits_) {
    limit->finalizeMultiDof();
    world->addMultiBodyConstraint(limit.get());
  }
}

void UrdfMultibody::removeFrom(btMultiBodyDynamicsWorld* world) {
  for (const auto& limit : limits_) world->removeMultiBodyConstraint(limit.get());
  for (const auto& motor : motors_) world->removeMultiBodyConstraint(motor.get());
  for (const Part& part : parts_) world->removeCollisionObject(part.collider.get());
  world->removeMultiBody(body_.get());
}

void UrdfMultibody::place(const std::vector<double>& positions) {
  for (int i = 0; i < body_->getNumLinks(); ++i) {
    body_->setJointPos(i, positions[static_cast<size_t>(i)]);
    body_->setJointVel(i, 0.0);
  }
  body_->clearForcesAndTorques();
  body_->clearConstraintForces();
  setTarget(positions, std::vector<double>(positions.size(), 0.0));
  updateColliders();
}

void UrdfMultibody::updateColliders() {
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> origins;
  body_->forwardKinematics(rotations, origins);
  body_->updateCollisionObjectWorldTransforms(rotations, origins);
}

void UrdfMultibody::setTarget(const std::vector<double>& positions,
                              const std::vector<double>& velocities) {
  for (size_t i = 0; i < motors_.size(); ++i) {
    motors_[i]->setPositionTarget(positions[i], kPositionGain);
    motors_[i]->setVelocityTarget(velocities[i], 1.0);
  }
}

std::vector<double> UrdfMultibody::positions() const {
  std::vector<double> positions(joint_names_.size());
  for (size_t i = 0; i < positions.size(); ++i)
    positions[i] = body_->getJointPos(static_cast<int>(i));
  return positions;
}

std::vector<double> UrdfMultibody::velocities() const {
  std::vector<double> velocities(joint_names_.size());
  for (size_t i = 0; i < velocities.size(); ++i)
    velocities[i] = body_->getJointVel(static_cast<int>(i));
  return velocities;
}

void UrdfMultibody::applyWrench(const Wrench& wrench_world) {
  const Vec3 lever = lastPose().translation() -
                     fromBullet(parts_.back().collider->getWorldTransform().getOrigin());
  const int link = body_->getNumLinks() - 1;
  body_->addLinkForce(link, toBullet(wrench_world.force));
  body_->addLinkTorque(link, toBullet(Vec3(wrench_world.torque + lever.cross(wrench_world.force))));
}

Pose UrdfMultibody::lastPose() const {
  const Part& part = parts_.back();
  return fromBullet(part.collider->getWorldTransform()) * part.T_part_body.inverse() * T_part_last_;
}

const std::string& UrdfMultibody::linkName(const btCollisionObject* collider, int shape) const {
  const auto part = std::find_if(parts_.begin(), parts_.end(), [collider](const Part& candidate) {
    return candidate.collider.get() == collider;
  });
  return part->names[static_cast<size_t>(shape)];
}

}  // namespace smore
