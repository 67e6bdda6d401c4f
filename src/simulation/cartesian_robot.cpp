// SPDX-License-Identifier: BSD-3-Clause
#include "cartesian_robot.h"

#include "smore/common/finite_path.h"
#include "smore/common/result.h"
#include "smore/kinematics/cartesian_joints.h"

namespace smore {
namespace {

constexpr double kStep = 0.001;        // [s]
constexpr int kSubstepsPerSample = 2;  // 500 Hz, as the UR5e's wrist sensor

}  // namespace

CartesianRobot::CartesianRobot(const Scenario& scenario, std::uint64_t seed, double sensor_cutoff)
    : hand_(scenario.start, scenario.linear_speed, scenario.angular_speed),
      object_(scenario, objectBody(scenario), scenario.start, HeldBody::Feel::kContactsOnly, kStep),
      sensor_(scenario.wrench_noise, kSubstepsPerSample * kStep, seed, {}, sensor_cutoff) {}

std::optional<Failure> CartesianRobot::follow(const Path& path) {
  requireFinite(path);
  hand_.follow(path);
  return std::nullopt;
}

std::optional<Failure> CartesianRobot::followJoints(const JointTrajectory& trajectory) {
  const Result<Path> path = cartesianPath(trajectory);
  if (!path) throw InputError(path.reason());
  return follow(*path);
}

std::optional<Failure> CartesianRobot::moveGripper(double /*position*/) {
  return Failure{"the Cartesian robot has no gripper"};
}

void CartesianRobot::place(const Pose& T_world_object) {
  requireFinite({T_world_object});
  hand_.place(T_world_object);
  object_.place(T_world_object);
}

WrenchSample CartesianRobot::advance() {
  for (int i = 0; i < kSubstepsPerSample; ++i) advanceSubstep();
  reading_ = sensor_.read(object_.environmentWrench(hand_.pose()));
  return {time(), reading_.wrench, hand_.pose()};
}

void CartesianRobot::advanceSubstep() {
  const Pose before = hand_.pose();
  hand_.advance(kStep);
  object_.advance(before, hand_.pose());
  ++substeps_;
}

double CartesianRobot::time() const { return static_cast<double>(substeps_) * kStep; }

std::vector<std::string> CartesianRobot::jointNames() const { return cartesianJointNames(); }

std::vector<double> CartesianRobot::jointPositions() const {
  return toCartesianJoints(hand_.pose());
}

}  // namespace smore
