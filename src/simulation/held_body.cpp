// SPDX-License-Identifier: BSD-3-Clause
#include "held_body.h"

#include <Eigen/Geometry>

namespace smore {
namespace {

Vec3 rotationVector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

}  // namespace

HeldBody::HeldBody(const Scenario& scenario, const CarriedBody& body, const Pose& T_world_hand,
                   Feel feel, double step)
    : mass_(body.mass),
      feel_(feel),
      step_(step),
      world_(scenario, body, feel == Feel::kEverything ? gravity() : Vec3::Zero(), step),
      spring_(WristSpringParameters{}, body.mass, step) {
  place(T_world_hand);
}

void HeldBody::place(const Pose& T_world_hand) {
  hand_velocity_ = {};
  const Pose T_world_body = hangingPose(T_world_hand);
  world_.place(T_world_body);
  environment_wrench_ = {};
  wrench_origin_ = T_world_body.translation();
}

// The spring gives way until it carries the weight. It turns the body a little, and the weight in
// its axes with it: small enough that the axes of the hand will do.
Pose HeldBody::hangingPose(const Pose& T_world_hand) const {
  if (feel_ == Feel::kContactsOnly) return T_world_hand;
  Wrench support;
  support.force = -mass_.mass * (T_world_hand.linear().transpose() * gravity());
  support.torque = mass_.center.cross(support.force);
  const WristDeflection deflection = spring_.deflectionUnder(support);
  const double angle = deflection.rotation.norm();
  Pose T_body_hand = Pose::Identity();
  T_body_hand.translation() = deflection.position;
  if (angle > 0.0) {
    T_body_hand.linear() = Eigen::AngleAxisd(angle, deflection.rotation / angle).toRotationMatrix();
  }
  return T_world_hand * T_body_hand.inverse();
}

void HeldBody::advance(const Pose& T_world_hand_before, const Pose& T_world_hand_after) {
  const HandVelocity before = hand_velocity_;
  hand_velocity_ = velocityBetween(T_world_hand_before, T_world_hand_after);
  if (feel_ == Feel::kContactsOnly && !world_.inContact()) {
    world_.changeVelocity(hand_velocity_.linear - before.linear,
                          hand_velocity_.angular - before.angular);
  }
  const Wrench spring = springWrench(T_world_hand_before, hand_velocity_);
  wrench_origin_ = world_.motion().T_world_object.translation();
  environment_wrench_ = {-spring.force, -spring.torque};
  world_.step(spring);
}

Wrench HeldBody::environmentWrench(const Pose& T_world_hand) const {
  Pose T_hand_world = T_world_hand.inverse();
  Pose T_world_wrench = Pose::Identity();
  T_world_wrench.translation() = wrench_origin_;
  return transformWrench(T_hand_world * T_world_wrench, environment_wrench_);
}

// The velocities that take the hand from pose to pose within one step, as the integrator of the
// dynamics would: a body that moves with the hand then has no deflection but rounding.
HeldBody::HandVelocity HeldBody::velocityBetween(const Pose& before, const Pose& after) const {
  if (after.isApprox(before, 0.0)) return {};
  HandVelocity velocity;
  velocity.linear = (after * mass_.center - before * mass_.center) / step_;
  velocity.angular = rotationVector(after.linear() * before.linear().transpose()) / step_;
  return velocity;
}

Wrench HeldBody::springWrench(const Pose& T_world_hand, const HandVelocity& hand_velocity) const {
  const ObjectMotion motion = world_.motion();
  const Pose T_object_hand = motion.T_world_object.inverse() * T_world_hand;
  const Eigen::Matrix3d world_in_object = motion.T_world_object.linear().transpose();
  WristDeflection deflection;
  deflection.position = T_object_hand.translation();
  deflection.rotation = rotationVector(T_object_hand.linear());
  deflection.angular_velocity = world_in_object * (hand_velocity.angular - motion.angular_velocity);
  deflection.linear_velocity = world_in_object * (hand_velocity.linear - motion.linear_velocity) -
                               deflection.angular_velocity.cross(mass_.center);
  const Wrench wrench_object = spring_.wrench(deflection);
  return {motion.T_world_object.linear() * wrench_object.force,
          motion.T_world_object.linear() * wrench_object.torque};
}

}  // namespace smore
