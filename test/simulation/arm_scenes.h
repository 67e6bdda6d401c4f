// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>

#include "smore/scenario/scenario.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

/// A ball below a handle that the gripper holds; the arm may move freely around the start.
inline Scenario ballInHand(const Pose& start) {
  Scenario scenario;
  scenario.name = "ball_in_hand";
  scenario.robot = RobotKind::kUr5e;
  scenario.motion = Motion::kSpatial;
  scenario.object = {{BoxShape{Vec3(0.03, 0.03, 0.07)}, makePose(Vec3(0, 0, 0.05))},
                     {SphereShape{0.03}, Pose::Identity()}};
  scenario.T_gripper_object = makePose(Vec3(0, 0, 0.065), Vec3(M_PI, 0, 0));
  scenario.start = start;
  scenario.goal = start;
  const Vec3 room = Vec3::Constant(0.02);
  scenario.workspace = {start.translation() - room, start.translation() + room};
  scenario.linear_speed = 0.05;
  scenario.angular_speed = 0.25;
  return scenario;
}

/// Poses of the object and directions from a seed.
class RandomScenes {
 public:
  explicit RandomScenes(unsigned seed) : random_(seed) {}

  double uniform(double min, double max) {
    return std::uniform_real_distribution<double>(min, max)(random_);
  }

  /// The object in front of the arm, the gripper pointing more or less down.
  Pose pose() {
    const double angle = uniform(-1.5, 1.5);
    const double reach = uniform(0.35, 0.55);
    return makePose(Vec3(reach * std::cos(angle), reach * std::sin(angle), uniform(0.15, 0.4)),
                    Vec3(uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-1.5, 1.5)));
  }

  /// A unit vector in the lower half of the object's frame: away from the gripper.
  Vec3 direction() {
    std::normal_distribution<double> normal;
    const Vec3 v(normal(random_), normal(random_), -std::abs(normal(random_)));
    return v.normalized();
  }

 private:
  std::mt19937 random_;
};

inline void settle(SimulatedRobot* robot, double seconds) {
  for (int i = 0; i < std::lround(500 * seconds); ++i) robot->advance();
}

}  // namespace smore
