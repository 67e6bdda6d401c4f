// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "contact_trials.h"
#include "smore/common/result.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {
namespace {

Scenario reference() {
  return loadScenario(SMORE_SOURCE_DIR "/config/scenarios/s_shape_two_pegs.yaml");
}

void runToEnd(SimulatedRobot* robot) {
  while (robot->moving()) robot->advance();
}

// Moves until the raw force passes `force`, stops and settles.
WrenchSample press(SimulatedRobot* robot, const Pose& target, double force) {
  robot->follow({target});
  while (robot->moving() && robot->advance().wrench.force.norm() < force) {
  }
  robot->stop();
  WrenchSample sample;
  for (int i = 0; i < 250; ++i) sample = robot->advance();
  return sample;
}

TEST(SimulatedRobot, followsAPathExactlyAndFeelsNothingInFreeSpace) {
  const auto robot =
      makeSimulatedRobot(sceneOf(sShape(), {{SphereShape{0.1}, Pose::Identity()}}), 1);
  const Pose end = makePose(Vec3(-1.2, 0.1, 0.2), Vec3(0.3, 0.2, -0.5));
  robot->follow({robot->pose(), makePose(Vec3(-1.1, -0.1, 0), Vec3(0, 0.4, 0)), end});
  while (robot->moving()) {
    const WrenchSample sample = robot->advance();
    EXPECT_LT(sample.wrench.force.norm(), 1e-6);
    EXPECT_LT(sample.wrench.torque.norm(), 1e-6);
    EXPECT_TRUE(robot->contacts().empty());
  }
  EXPECT_EQ(robot->pose().matrix(), end.matrix());
}

TEST(SimulatedRobot, samplesAtFiveHundredHertz) {
  const auto robot = makeSimulatedRobot(reference(), 1);
  EXPECT_EQ(robot->time(), 0.0);
  for (int i = 1; i <= 1000; ++i) EXPECT_NEAR(robot->advance().time, 0.002 * i, 1e-12);
  EXPECT_NEAR(robot->time(), 2.0, 1e-12);
}

TEST(SimulatedRobot, jointsGiveThePose) {
  const auto robot =
      makeSimulatedRobot(sceneOf(sShape(), {{SphereShape{0.1}, Pose::Identity()}}), 1);
  const std::vector<std::string> names{"x_joint",   "y_joint",     "z_joint",
                                       "yaw_joint", "pitch_joint", "roll_joint"};
  EXPECT_EQ(robot->jointNames(), names);
  RandomContacts trials(3);
  for (int i = 0; i < 100; ++i) {
    const Vec3 turn(trials.uniform(-3, 3), trials.uniform(-1.5, 1.5), trials.uniform(-3, 3));
    robot->place(makePose(Vec3(-2, trials.uniform(-1, 1), 0.5), turn));
    const std::vector<double> q = robot->jointPositions();
    const Pose pose = makePose(Vec3(q[0], q[1], q[2]), Vec3(q[5], q[4], q[3]));
    EXPECT_TRUE(pose.isApprox(robot->pose(), 1e-12));
  }
}

TEST(SimulatedRobot, placingForgetsContactAndMotion) {
  const auto robot = makeSimulatedRobot(reference(), 1);
  EXPECT_GT(press(robot.get(), reference().goal, 10.0).wrench.force.norm(), 2.0);
  EXPECT_FALSE(robot->contacts().empty());
  robot->follow({reference().goal});
  robot->place(reference().start);
  EXPECT_FALSE(robot->moving());
  const WrenchSample sample = robot->advance();
  EXPECT_LT(sample.wrench.force.norm(), 1e-9);
  EXPECT_TRUE(robot->contacts().empty());
  EXPECT_EQ(sample.T_world_object.matrix(), reference().start.matrix());
}

TEST(SimulatedRobot, twoRunsAreBitIdentical) {
  Scenario scenario = reference();
  scenario.wrench_noise = {0.5, 0.02, Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3), 0.01};
  const auto run = [&scenario](std::uint64_t seed) {
    const auto robot = makeSimulatedRobot(scenario, seed);
    std::vector<double> record;
    for (int leg = 0; leg < 4; ++leg) {
      robot->follow({makePose(Vec3(leg % 2 == 0 ? -0.13 : 0.13, 0.05, 0), Vec3(0, 0, 0.1 * leg))});
      while (robot->moving()) {
        const WrenchSample sample = robot->advance();
        for (const Vec3& vector : {sample.wrench.force, sample.wrench.torque}) {
          record.insert(record.end(), vector.data(), vector.data() + vector.size());
        }
      }
      if (leg == 2) robot->place(scenario.start);
    }
    return record;
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

// A ball pushed straight against a wall: the force is along the normal and the spring's.
TEST(SimulatedRobot, forceOfAHeadOnContactIsInClosedForm) {
  const Shape wall{BoxShape{Vec3(0.1, 1, 1)}, makePose(Vec3(0.05, 0, 0))};
  Scenario scenario = sceneOf({{SphereShape{0.05}, Pose::Identity()}}, {wall});
  const auto robot = makeSimulatedRobot(scenario, 1);
  robot->place(makePose(Vec3(-0.1, 0, 0)));
  robot->follow({makePose(Vec3(-0.049, 0, 0))});  // a millimetre into the wall
  runToEnd(robot.get());
  WrenchSample sample;
  for (int i = 0; i < 500; ++i) sample = robot->advance();
  const double w = std::sqrt(10000.0 / scenario.object_mass) * 0.001;
  EXPECT_NEAR(sample.wrench.force.x(), -10.0 / (1.0 + 1.4 * w + w * w), 0.05);
  EXPECT_NEAR(sample.wrench.force.tail<2>().norm(), 0.0, 1e-6);
  EXPECT_NEAR(sample.wrench.torque.norm(), 0.0, 1e-6);
}

TEST(SimulatedRobot, frictionStaysInItsConeAndReachesItWhenSliding) {
  const Shape wall{BoxShape{Vec3(0.1, 2, 2)}, makePose(Vec3(0.05, 0, 0))};
  for (const double friction : {0.0, 0.3, 0.6}) {
    Scenario scenario = sceneOf({{SphereShape{0.05}, Pose::Identity()}}, {wall});
    scenario.friction = friction;
    const auto robot = makeSimulatedRobot(scenario, 1);
    robot->place(makePose(Vec3(-0.06, 0, 0)));
    robot->follow({makePose(Vec3(-0.049, 0, 0)), makePose(Vec3(-0.049, 0.07, 0.04))});
    double ratio = 0.0;
    while (robot->moving()) {
      robot->advance();
      for (const ContactPoint& contact : robot->contacts()) {
        const double normal = -contact.force.x();
        ratio = contact.force.tail<2>().norm() / normal;
        EXPECT_LE(ratio, friction + 1e-6);
      }
    }
    EXPECT_NEAR(ratio, friction, 1e-3);
  }
}

// The normal is the ball's at the contact point, which the engine keeps while it slides up to 1 mm:
// an error of 0.02 rad at a radius of 5 cm.
TEST(SimulatedRobot, frictionStaysInItsConeInRandomContacts) {
  constexpr double kNormalError = 0.022;
  RandomContacts trials(17);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Shape ball{SphereShape{0.05}, Pose::Identity()};
    Scenario scenario = trials.scene();
    scenario.environment = {ball};
    const auto robot = makeSimulatedRobot(scenario, seed);
    robot->follow({trials.target(scenario.start)});
    constexpr double kGreatestForce = 30.0;
    while (robot->moving() && robot->advance().wrench.force.norm() < kGreatestForce) {
      for (const ContactPoint& contact : robot->contacts()) {
        const Vec3 normal = contact.position.normalized();
        const double pressing = contact.force.dot(normal);
        const double tangential = (contact.force - pressing * normal).norm();
        EXPECT_LE(tangential, (0.3 + kNormalError) * pressing + 1e-3);
      }
    }
  }
}

// Pressed twenty times deeper than a contact ever is, ten times faster than usual, against a thin
// plate.
TEST(SimulatedRobot, doesNotTunnelThroughThinSolids) {
  const std::vector<Shape> plate{{BoxShape{Vec3(0.005, 1, 1)}, Pose::Identity()}};
  Scenario scenario = sceneOf({{BoxShape{Vec3(0.2, 0.01, 0.01)}, Pose::Identity()}}, plate);
  scenario.linear_speed = 1.0;
  const auto robot = makeSimulatedRobot(scenario, 1);
  robot->place(makePose(Vec3(-0.3, 0, 0)));
  robot->follow({makePose(Vec3(-0.0825, 0, 0))});  // 2 cm beyond the touch
  runToEnd(robot.get());
  WrenchSample sample;
  for (int i = 0; i < 500; ++i) sample = robot->advance();
  EXPECT_LT(sample.wrench.force.x(), -150.0);
  for (const ContactPoint& contact : robot->contacts())
    EXPECT_NEAR(contact.position.x(), -0.0025, 1e-3);
}

TEST(SimulatedRobot, planarContactsKeepTheObjectInItsPlane) {
  const auto robot = makeSimulatedRobot(reference(), 1);
  for (const double y : {-0.1, 0.0, 0.1}) {
    for (const double x : {-0.3, 0.3}) {
      robot->place(reference().start);
      const WrenchSample sample = press(robot.get(), makePose(Vec3(x, y, 0)), 10.0);
      EXPECT_GT(sample.wrench.force.norm(), 2.0);
      EXPECT_LT(std::abs(sample.wrench.force.z()), 0.2);
      EXPECT_LT(sample.wrench.torque.head<2>().norm(), 0.03 * sample.wrench.force.norm() + 0.01);
      for (const ContactPoint& contact : robot->contacts()) {
        EXPECT_LT(std::abs(contact.position.z()), 0.031);
      }
    }
  }
}

TEST(SimulatedRobot, retreatsFromContactWithoutResidualForce) {
  const auto robot = makeSimulatedRobot(reference(), 1);
  press(robot.get(), reference().goal, 10.0);
  robot->follow({reference().start});
  runToEnd(robot.get());
  WrenchSample sample;
  for (int i = 0; i < 100; ++i) sample = robot->advance();
  EXPECT_LT(sample.wrench.force.norm(), 1e-3);
  EXPECT_TRUE(robot->contacts().empty());
}

// Rolled over, moved through, rolled back: the shipped spatial scene has a way out.
TEST(SimulatedRobot, passesTheSlitOnItsSide) {
  const Scenario scenario = loadScenario(SMORE_SOURCE_DIR "/config/scenarios/slit.yaml");
  const auto robot = makeSimulatedRobot(scenario, 1);
  const Vec3 on_its_side(M_PI_2, 0, 0);
  const Path path{makePose(Vec3::Zero(), on_its_side), makePose(Vec3(-1, 0, 0), on_its_side),
                  scenario.goal};
  robot->follow(path);
  while (robot->moving()) ASSERT_LT(robot->advance().wrench.force.norm(), 1e-6);
  robot->place(scenario.start);
  robot->follow({scenario.goal});
  while (robot->moving() && robot->advance().wrench.force.norm() < 5.0) {
  }
  EXPECT_TRUE(robot->moving());
}

// A tetrahedron with one face pushed in: concave, a surface to the physics engine. Its hollow is
// open towards (1, 1, 1); its flat face at z = 0 is pressed from below by a convex mesh.
TEST(SimulatedRobot, meshesTouchWhereTheirFacesAre) {
  MeshShape hollow;
  hollow.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0.9, 0.9, 0.9}};
  hollow.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}};
  MeshShape wedge;
  wedge.vertices = {{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0, 0.2, 0}, {0, 0, 0.1}};
  wedge.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const std::vector<Shape> object{{wedge, Pose::Identity()}};
  const auto robot = makeSimulatedRobot(sceneOf(object, {{hollow, Pose::Identity()}}), 1);
  robot->place(makePose(Vec3(0.5, 0.5, -0.2)));
  const WrenchSample sample = press(robot.get(), makePose(Vec3(0.5, 0.5, 0)), 15.0);
  EXPECT_NEAR(robot->pose().translation().z(), -0.1, 2e-3);
  EXPECT_LT(sample.wrench.force.z(), -2.0);
  EXPECT_LT(sample.wrench.force.head<2>().norm(), 0.01);
  const Wrench sum = sumOf(robot->contacts(), robot->pose());
  EXPECT_NEAR((sum.force - sample.wrench.force).norm(), 0.0, 1e-3);
}

TEST(SimulatedRobot, refusesPosesThatAreNotFinite) {
  const auto robot = makeSimulatedRobot(reference(), 1);
  Pose broken = Pose::Identity();
  broken.translation().x() = std::nan("");
  robot->follow({makePose(Vec3(0.01, 0, 0))});
  EXPECT_THROW(robot->follow({Pose::Identity(), broken}), InputError);
  EXPECT_THROW(robot->place(broken), InputError);
  runToEnd(robot.get());
  EXPECT_DOUBLE_EQ(robot->pose().translation().x(), 0.01);
}

TEST(SimulatedRobot, otherRobotsAreRefusedWithARemedy) {
  Scenario scenario = reference();
  scenario.robot = RobotKind::kUr5e;
  EXPECT_THROW(makeSimulatedRobot(scenario, 1), InputError);
}

TEST(SimulatedRobot, runsAtLeastTwentyTimesFasterThanRealTime) {
  const auto robot = makeSimulatedRobot(reference(), 1);
  const std::clock_t begin = std::clock();
  for (int i = 0; i < 10; ++i) {
    robot->place(reference().start);
    press(robot.get(), reference().goal, 10.0);
  }
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  RecordProperty("real_time_factor", static_cast<int>(robot->time() / seconds));
  EXPECT_GT(robot->time(), 20.0 * seconds);
}

}  // namespace
}  // namespace smore
