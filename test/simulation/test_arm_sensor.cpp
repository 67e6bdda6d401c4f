// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "arm_scenes.h"
#include "contact_trials.h"
#include "smore/kinematics/kinematic_tree.h"
#include "smore/simulation/mass_properties.h"

namespace smore {
namespace {

constexpr double kGravity = 9.80665;

void moveTo(SimulatedRobot* robot, const Path& path) {
  const auto failure = robot->follow(path);
  ASSERT_FALSE(failure) << failure->reason;
  while (robot->moving()) robot->advance();
}

// Contacts and weight at the origin and in the axes of the sensor's frame.
Wrench expectedReading(const SimulatedRobot& robot, const MassProperties& load_sensor) {
  const Pose T_world_sensor = robot.pose() * robot.T_sensor_object().inverse();
  Wrench wrench = sumOf(robot.contacts(), T_world_sensor);
  const Vec3 weight =
      T_world_sensor.linear().transpose() * Vec3(0, 0, -kGravity * load_sensor.mass);
  wrench.force += weight;
  wrench.torque += load_sensor.center.cross(weight);
  return wrench;
}

// Gripper by the URDF (fingers as the grasp has them matter little) and object.
MassProperties loadOf(const Scenario& scenario, const Pose& T_sensor_object) {
  const UrdfModel urdf = armUrdf(RobotKind::kUr5e);
  const KinematicTree gripper(urdf, "tool0_controller");
  const std::vector<Pose> poses = gripper.linkPoses({0.5});
  std::vector<MassProperties> bodies{
      transformMass(T_sensor_object, massProperties(scenario.object, scenario.object_mass))};
  for (size_t i = 0; i < poses.size(); ++i) {
    const auto& inertial = urdf->getLink(gripper.links()[i].name)->inertial;
    if (!inertial) continue;
    MassProperties body;
    body.mass = inertial->mass;
    body.center = poses[i] * toPose(inertial->origin) * Vec3::Zero();
    bodies.push_back(body);
  }
  return joined(bodies);
}

TEST(ArmSensor, readsContactsAndWeightInRandomConfigurations) {
  RandomScenes scenes(1);
  int pressed = 0;
  for (int trial = 0; trial < 50;) {
    Scenario scenario = ballInHand(scenes.pose());
    constexpr double kRadius = 0.05;
    constexpr double kGap = 0.004;
    const Vec3 direction = scenes.direction();
    Pose ball = Pose::Identity();
    ball.translation() = scenario.start * ((0.03 + kRadius + kGap) * direction);
    scenario.environment = {{SphereShape{kRadius}, ball}};
    const auto robot = makeSimulatedRobot(scenario, 1);
    const MassProperties load = loadOf(scenario, robot->T_sensor_object());

    settle(robot.get(), 0.3);
    if (robot->fault()) continue;  // a link stands in the random ball
    ++trial;
    const Wrench free = robot->reading().wrench;
    const Wrench weight = expectedReading(*robot, load);
    EXPECT_LT((free.force - weight.force).norm(), 0.02 * weight.force.norm() + 0.05);
    EXPECT_LT((free.torque - weight.torque).norm(), 0.02 * weight.torque.norm() + 0.03);

    Pose target = scenario.start;
    target.translation() = scenario.start * (scenes.uniform(1.3, 1.6) * kGap * direction);
    ASSERT_FALSE(robot->follow({target}));
    while (robot->moving()) robot->advance();
    settle(robot.get(), 0.5);
    ASSERT_FALSE(robot->fault()) << robot->fault()->reason;
    const Wrench contact = sumOf(robot->contacts(), Pose::Identity());
    pressed += contact.force.norm() > 5.0;
    const Wrench expected = expectedReading(*robot, load);
    const Wrench reading = robot->reading().wrench;
    EXPECT_LT((reading.force - expected.force).norm(), 0.02 * expected.force.norm() + 0.05);
    EXPECT_LT((reading.torque - expected.torque).norm(), 0.02 * expected.torque.norm() + 0.03);
    for (const ContactPoint& point : robot->contacts()) EXPECT_EQ(point.body, kObjectBody);
  }
  EXPECT_GE(pressed, 45);
}

// Slow motion with the ball of the hand sliding over another one.
TEST(ArmSensor, readsContactsAndWeightInSlowMotion) {
  RandomScenes scenes(2);
  for (int trial = 0; trial < 10; ++trial) {
    Scenario scenario = ballInHand(scenes.pose());
    scenario.linear_speed = 0.02;
    Pose floor = scenario.start;
    floor.translation() = scenario.start * Vec3(0, 0, -0.03 - 0.004 - 0.01);
    scenario.environment = {{BoxShape{Vec3(0.2, 0.2, 0.02)}, floor}};
    const auto robot = makeSimulatedRobot(scenario, 1);
    const MassProperties load = loadOf(scenario, robot->T_sensor_object());
    Pose down = scenario.start;
    down.translation() = scenario.start * Vec3(0, 0, -0.005);
    moveTo(robot.get(), {down});
    settle(robot.get(), 0.3);
    Pose aside = down;
    aside.translation() = down * Vec3(0.03, 0, 0);
    ASSERT_FALSE(robot->follow({aside}));
    while (robot->moving()) {
      robot->advance();
      const Wrench expected = expectedReading(*robot, load);
      EXPECT_LT((robot->reading().wrench.force - expected.force).norm(),
                0.05 * expected.force.norm() + 0.05);
      EXPECT_FALSE(robot->contacts().empty());
    }
  }
}

TEST(ArmSensor, saturatesAtTheEndOfTheSensorsRange) {
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  scenario.wrench_noise.force_bias = Vec3(49.5, 0, 0);
  const auto robot = makeSimulatedRobot(scenario, 1);
  settle(robot.get(), 0.1);
  EXPECT_FALSE(robot->reading().saturated);
  scenario.wrench_noise.force_bias = Vec3(55, 0, 0);
  const auto saturated = makeSimulatedRobot(scenario, 1);
  settle(saturated.get(), 0.1);
  EXPECT_TRUE(saturated->reading().saturated);
  EXPECT_EQ(saturated->reading().wrench.force.x(), 50.0);
}

}  // namespace
}  // namespace smore
