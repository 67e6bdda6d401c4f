// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "smore/contact/contact_sensing.h"
#include "smore/simulation/scene_check.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

/// The bars of the reference scene's object: a shape with edges, corners, faces and long levers.
inline std::vector<Shape> sShape() {
  const auto bar = [](const Vec3& size, const Vec3& position) {
    return Shape{BoxShape{size}, makePose(position)};
  };
  return {bar(Vec3(0.42, 0.06, 0.06), Vec3(0, 0.30, 0)), bar(Vec3(0.42, 0.06, 0.06), Vec3::Zero()),
          bar(Vec3(0.42, 0.06, 0.06), Vec3(0, -0.30, 0)),
          bar(Vec3(0.06, 0.36, 0.06), Vec3(-0.18, 0.15, 0)),
          bar(Vec3(0.06, 0.36, 0.06), Vec3(0.18, -0.15, 0))};
}

/// A spatial scene of two solids without noise; start and goal are up to the trial.
inline Scenario sceneOf(const std::vector<Shape>& object, const std::vector<Shape>& environment) {
  Scenario scenario;
  scenario.name = "trial";
  scenario.motion = Motion::kSpatial;
  scenario.object = object;
  scenario.environment = environment;
  scenario.start = makePose(Vec3(-1.0, 0, 0));
  scenario.goal = scenario.start;
  scenario.workspace = {Vec3::Constant(-3.0), Vec3::Constant(3.0)};
  return scenario;
}

/// Seeded scenes and motions that end in contact: the S-shape in a random orientation moves and
/// turns towards a peg, a block or a ball.
class RandomContacts {
 public:
  explicit RandomContacts(unsigned seed) : random_(seed) {}

  Scenario scene() {
    Shape solid;
    const int kind = static_cast<int>(uniform(0.0, 3.0));
    if (kind == 0) solid.geometry = CylinderShape{uniform(0.01, 0.06), uniform(0.1, 0.4)};
    if (kind == 1) solid.geometry = BoxShape{Vec3(uniform(0.05, 0.3), uniform(0.05, 0.3), 0.2)};
    if (kind == 2) solid.geometry = SphereShape{uniform(0.02, 0.1)};
    solid.pose = makePose(Vec3::Zero(), Vec3(uniform(-3, 3), uniform(-3, 3), uniform(-3, 3)));
    Scenario scenario = sceneOf(sShape(), {solid});
    SceneCheck check(scenario);
    do {
      scenario.start = randomPose(0.5);
    } while (check.touches(scenario.start));
    scenario.goal = scenario.start;
    return scenario;
  }

  /// A pose to move to: near the origin, turned by up to 0.3 rad.
  Pose target(const Pose& start) {
    const Vec3 turn(uniform(-0.3, 0.3), uniform(-0.3, 0.3), uniform(-0.3, 0.3));
    Pose target = makePose(Vec3::Zero(), turn);
    target.linear() = start.linear() * target.linear();
    target.translation() = -0.3 * start.translation();
    return target;
  }

  double uniform(double min, double max) {
    return std::uniform_real_distribution<double>(min, max)(random_);
  }

 private:
  Pose randomPose(double distance) {
    std::normal_distribution<double> normal;
    const Vec3 direction(normal(random_), normal(random_), normal(random_));
    const Eigen::Quaterniond turn(normal(random_), normal(random_), normal(random_),
                                  normal(random_));
    Pose pose = Pose::Identity();
    pose.linear() = turn.normalized().toRotationMatrix();
    pose.translation() = distance * direction.normalized();
    return pose;
  }

  std::mt19937 random_;
};

/// Moves to `target` through the contact sensing that the rest of the project uses and stops at the
/// contact, as the robot's reflex does. The observation with the line of action, or nothing where
/// the motion ended without one. The robot stands as it was when the line was given.
inline std::optional<ContactObservation> touch(SimulatedRobot* robot, const Pose& target) {
  ContactSensing sensing(ContactSensingParameters{});
  while (!sensing.tared()) (void)sensing.process(robot->advance());
  robot->follow({target});
  constexpr int kLongestMotion = 20000;
  for (int i = 0; i < kLongestMotion; ++i) {
    const bool was_moving = robot->moving();
    const auto observation = sensing.process(robot->advance());
    if (!observation) return std::nullopt;
    if (observation->line) return *observation;
    if (observation->state == ContactState::kContact) robot->stop();
    if (!was_moving && observation->state == ContactState::kFree) return std::nullopt;
  }
  return std::nullopt;
}

inline Vec3 forceWeightedCenter(const std::vector<ContactPoint>& contacts) {
  Vec3 center = Vec3::Zero();
  double total = 0.0;
  for (const ContactPoint& contact : contacts) {
    center += contact.force.norm() * contact.position;
    total += contact.force.norm();
  }
  return center / total;
}

/// Wrench of the contacts at the origin and in the axes of the frame at `T_world_frame`.
inline Wrench sumOf(const std::vector<ContactPoint>& contacts, const Pose& T_world_frame) {
  Wrench sum;
  for (const ContactPoint& contact : contacts) {
    sum.force += contact.force;
    sum.torque += contact.position.cross(contact.force);
  }
  return transformWrench(T_world_frame.inverse(), sum);
}

/// Whether all contacts are of one convex part of the object: one patch, since the environment of a
/// trial is one convex solid. Others are jams of two or more.
inline bool onOnePatch(const Scenario& scenario, const Pose& T_world_object,
                       const std::vector<ContactPoint>& contacts) {
  std::optional<size_t> patch;
  for (const ContactPoint& contact : contacts) {
    const Vec3 point = T_world_object.inverse() * contact.position;
    size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < scenario.object.size(); ++i) {
      const double distance = std::abs(signedDistance({scenario.object[i]}, point));
      if (distance < least) nearest = i;
      least = std::min(least, distance);
    }
    if (patch.value_or(nearest) != nearest) return false;
    patch = nearest;
  }
  return patch.has_value();
}

}  // namespace smore
