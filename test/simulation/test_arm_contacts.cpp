// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "arm_scenes.h"
#include "contact_trials.h"
#include "smore/kinematics/arm_model.h"

namespace smore {
namespace {

TEST(ArmContacts, namesTheLinkThatTouchesTheScene) {
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.2, 0.2)));
  const auto probe = makeSimulatedRobot(scenario, 1);
  // A post where the forearm comes by when the arm swings round.
  const ArmModel arm(armUrdf(RobotKind::kUr5e));
  JointVector swung = toJointVector(probe->jointPositions());
  swung[0] -= 0.7;
  const Vec3 forearm =
      arm.linkPoses(swung)[static_cast<size_t>(arm.tree().linkIndex("forearm_link"))] *
      Vec3(-0.15, 0, 0);
  scenario.environment = {{SphereShape{0.03}, makePose(forearm)}};
  const auto robot = makeSimulatedRobot(scenario, 1);
  std::vector<double> target = robot->jointPositions();
  target[0] -= 1.0;
  ASSERT_FALSE(robot->followJoints({robot->jointNames(), {{8.0, target, {}}}}));
  while (robot->moving()) robot->advance();
  ASSERT_TRUE(robot->fault());
  EXPECT_EQ(robot->fault()->reason, "the link forearm_link touches the environment");
  EXPECT_TRUE(robot->contacts().empty());
  // Away from it the arm may move.
  target[0] += 1.0;
  ASSERT_FALSE(robot->followJoints({robot->jointNames(), {{8.0, target, {}}}}));
  while (robot->moving()) robot->advance();
  EXPECT_FALSE(robot->fault());
}

// Points on the surface of a shape, about a centimetre apart, in its parent frame.
std::vector<Vec3> surfacePoints(const Shape& shape) {
  std::vector<Vec3> points;
  const Bounds bounds = boundsOf({{shape.geometry, Pose::Identity()}});
  const Vec3 size = bounds.max - bounds.min;
  constexpr int kCells = 12;
  for (int x = 0; x <= kCells; ++x) {
    for (int y = 0; y <= kCells; ++y) {
      for (int z = 0; z <= kCells; ++z) {
        const Vec3 point = bounds.min + size.cwiseProduct(Vec3(x, y, z) / kCells);
        const Vec3 placed = shape.pose * point;
        if (signedDistance({shape}, placed) <= 1e-9) points.push_back(placed);
      }
    }
  }
  return points;
}

// No link is ever deeper in the scene than two millimetres without a fault (the engine rounds edges
// by one, and a step takes half of one): random motions of the joints among random pegs, against
// points of the links in the solids' distance functions.
TEST(ArmContacts, noLinkPassesThroughTheSceneUnreported) {
  const UrdfModel urdf = armUrdf(RobotKind::kUr5e);
  const ArmModel arm(urdf);
  const int tool = arm.tree().linkIndex("tool0_controller");
  std::vector<std::pair<size_t, std::vector<Vec3>>> links;
  for (size_t i = 0; i < static_cast<size_t>(tool); ++i) {
    if (arm.jointCountBefore(static_cast<int>(i)) == 0) continue;
    std::vector<Vec3> points;
    for (const Shape& shape : collisionShapes(urdf, arm.tree().links()[i].name)) {
      const std::vector<Vec3> more = surfacePoints(shape);
      points.insert(points.end(), more.begin(), more.end());
    }
    links.emplace_back(i, points);
  }
  RandomScenes scenes(3);
  int faults = 0;
  for (int trial = 0; trial < 12; ++trial) {
    Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.3)));
    for (int peg = 0; peg < 4; ++peg) {
      const double angle = scenes.uniform(0.6, 2.5) * (peg % 2 == 0 ? 1.0 : -1.0);
      const double reach = scenes.uniform(0.25, 0.5);
      scenario.environment.push_back(
          {CylinderShape{0.03, 0.8},
           makePose(Vec3(reach * std::cos(angle), reach * std::sin(angle), 0.4))});
    }
    const auto robot = makeSimulatedRobot(scenario, 1);
    std::vector<double> target = robot->jointPositions();
    for (double& value : target) value += scenes.uniform(-0.3, 0.3);
    target[0] += trial % 2 == 0 ? 1.6 : -1.6;
    ASSERT_FALSE(robot->followJoints({robot->jointNames(), {{2.0, target, {}}}}));
    for (int sample = 0; robot->moving(); ++sample) {
      robot->advance();
      if (sample % 10 != 0 || robot->fault()) continue;
      const auto poses = arm.linkPoses(toJointVector(robot->jointPositions()));
      for (const auto& [link, points] : links) {
        for (const Vec3& point : points) {
          ASSERT_GT(signedDistance(scenario.environment, poses[link] * point), -2e-3)
              << arm.tree().links()[link].name;
        }
      }
    }
    faults += robot->fault().has_value();
  }
  EXPECT_GE(faults, 6);
}

TEST(ArmContacts, tellsTheGrippersContactFromTheObjects) {
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  // A bar beside the fingers, above the object's ball.
  scenario.environment = {
      {BoxShape{Vec3(0.2, 0.02, 0.02)}, makePose(Vec3(0.45, 0.1 + 0.075, 0.2 + 0.11))}};
  const auto robot = makeSimulatedRobot(scenario, 1);
  ASSERT_FALSE(robot->follow({makePose(Vec3(0.45, 0.15, 0.2))}));
  while (robot->moving() && robot->contacts().empty()) robot->advance();
  ASSERT_FALSE(robot->contacts().empty());
  EXPECT_NE(robot->contacts().front().body, kObjectBody);
  EXPECT_EQ(robot->contacts().front().body, "right_outer_knuckle");
}

// From the sample that takes the mean over the fast window over the threshold to joints at rest.
TEST(ArmContacts, theReflexStopsTheJointsWithinTwentyMilliseconds) {
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  scenario.environment = {{BoxShape{Vec3(0.3, 0.1, 0.1)}, makePose(Vec3(0.45, 0.2, 0.2))}};
  const auto robot = makeSimulatedRobot(scenario, 1);
  ContactSensing sensing(ContactSensingParameters{});
  while (!sensing.tared()) (void)sensing.process(robot->advance());
  ASSERT_FALSE(robot->follow({makePose(Vec3(0.45, 0.15, 0.2))}));
  const ContactDetectorParameters detector;
  std::deque<Vec3> window;
  double passed = -1.0;
  while (robot->moving()) {
    const auto observation = sensing.process(robot->advance());
    window.push_back(sensing.compensated().force);
    if (window.size() > 3) window.pop_front();  // 4 ms at 500 Hz
    const Vec3 mean = std::accumulate(window.begin(), window.end(), Vec3(0, 0, 0)) / 3.0;
    if (passed < 0.0 && mean.norm() >= detector.contact_force) passed = robot->time();
    if (observation->state == ContactState::kContact) robot->stop();
  }
  ASSERT_GT(passed, 0.0);
  const auto at_rest = [&robot] {
    const std::vector<double> velocities = robot->jointVelocities();
    return std::all_of(velocities.begin(), velocities.end(),
                       [](double velocity) { return std::abs(velocity) < 1e-3; });
  };
  while (!at_rest()) robot->advance();
  EXPECT_LE(robot->time() - passed, 0.020);
  EXPECT_LT(sumOf(robot->contacts(), Pose::Identity()).force.norm(), 30.0);
}

}  // namespace
}  // namespace smore
