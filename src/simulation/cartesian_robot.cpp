// SPDX-License-Identifier: BSD-3-Clause
#include "cartesian_robot.h"

#include <Eigen/Geometry>
#include <cmath>

#include "smore/common/result.h"

namespace smore {
namespace {

constexpr double kStep = 0.001;        // [s]
constexpr int kSubstepsPerSample = 2;  // 500 Hz, as the UR5e's wrist sensor

Vec3 rotationVector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

void requireFinite(const Pose& pose) {
  if (!isFinite(pose)) {
    throw InputError(
        "a commanded pose has a value that is not finite; send finite positions and "
        "a unit quaternion");
  }
}

}  // namespace

CartesianRobot::CartesianRobot(const Scenario& scenario, std::uint64_t seed)
    : object_(massProperties(scenario.object, scenario.object_mass)),
      hand_(scenario.start, scenario.linear_speed, scenario.angular_speed),
      world_(scenario, object_, kStep),
      spring_(WristSpringParameters{}, object_, kStep),
      sensor_(scenario.wrench_noise, kSubstepsPerSample * kStep, seed),
      wrench_origin_(scenario.start.translation()) {}

void CartesianRobot::follow(const Path& path) {
  for (const Pose& pose : path) requireFinite(pose);
  hand_.follow(path);
}

void CartesianRobot::place(const Pose& T_world_object) {
  requireFinite(T_world_object);
  hand_.place(T_world_object);
  hand_velocity_ = {};
  world_.place(T_world_object);
  environment_wrench_ = {};
}

WrenchSample CartesianRobot::advance() {
  for (int i = 0; i < kSubstepsPerSample; ++i) advanceSubstep();
  Pose T_hand_world = hand_.pose().inverse();
  Pose T_world_wrench = Pose::Identity();
  T_world_wrench.translation() = wrench_origin_;
  WrenchSample sample;
  sample.time = time();
  sample.wrench = sensor_.read(transformWrench(T_hand_world * T_world_wrench, environment_wrench_));
  sample.T_world_object = hand_.pose();
  return sample;
}

// The wrench of the spring acts during the whole step, from where hand and object are at its
// beginning.
void CartesianRobot::advanceSubstep() {
  const Pose T_world_hand = hand_.pose();
  const HandVelocity before = hand_velocity_;
  hand_velocity_ = moveHand();
  if (!world_.inContact()) {
    world_.changeVelocity(hand_velocity_.linear - before.linear,
                          hand_velocity_.angular - before.angular);
  }
  const Wrench spring = springWrench(T_world_hand, hand_velocity_);
  wrench_origin_ = world_.motion().T_world_object.translation();
  environment_wrench_ = {-spring.force, -spring.torque};
  world_.step(spring);
  ++substeps_;
}

// The velocities that take the hand from pose to pose within one step, as the integrator of the
// dynamics would: an object that moves with the hand then has no deflection but rounding.
CartesianRobot::HandVelocity CartesianRobot::moveHand() {
  const Pose before = hand_.pose();
  hand_.advance(kStep);
  if (!hand_.moving() && hand_.pose().isApprox(before, 0.0)) return {};
  const Pose& after = hand_.pose();
  HandVelocity velocity;
  velocity.linear = (after * object_.center - before * object_.center) / kStep;
  velocity.angular = rotationVector(after.linear() * before.linear().transpose()) / kStep;
  return velocity;
}

Wrench CartesianRobot::springWrench(const Pose& T_world_hand,
                                    const HandVelocity& hand_velocity) const {
  const ObjectMotion motion = world_.motion();
  const Pose T_object_hand = motion.T_world_object.inverse() * T_world_hand;
  const Eigen::Matrix3d world_in_object = motion.T_world_object.linear().transpose();
  WristDeflection deflection;
  deflection.position = T_object_hand.translation();
  deflection.rotation = rotationVector(T_object_hand.linear());
  deflection.angular_velocity = world_in_object * (hand_velocity.angular - motion.angular_velocity);
  deflection.linear_velocity = world_in_object * (hand_velocity.linear - motion.linear_velocity) -
                               deflection.angular_velocity.cross(object_.center);
  const Wrench wrench_object = spring_.wrench(deflection);
  return {motion.T_world_object.linear() * wrench_object.force,
          motion.T_world_object.linear() * wrench_object.torque};
}

double CartesianRobot::time() const { return static_cast<double>(substeps_) * kStep; }

std::vector<std::string> CartesianRobot::jointNames() const {
  return {"x_joint", "y_joint", "z_joint", "yaw_joint", "pitch_joint", "roll_joint"};
}

// The joints stand in this order from the world to the hand: the pose is
// translation(x, y, z) rotation_z(yaw) rotation_y(pitch) rotation_x(roll).
std::vector<double> CartesianRobot::jointPositions() const {
  const Pose pose = hand_.pose();
  const Eigen::Matrix3d& r = pose.linear();
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  return {pose.translation().x(),
          pose.translation().y(),
          pose.translation().z(),
          std::atan2(r(1, 0), r(0, 0)),
          pitch,
          std::atan2(r(2, 1), r(2, 2))};
}

}  // namespace smore
