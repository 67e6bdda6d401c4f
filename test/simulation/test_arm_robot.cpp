// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

#include "../common/refusal.h"
#include "arm_scenes.h"
#include "smore/common/result.h"
#include "smore/kinematics/arm_model.h"

namespace smore {
namespace {

TEST(ArmRobot, followsAPathWithItsMotors) {
  const Pose start = makePose(Vec3(0.45, 0.1, 0.2));
  const auto robot = makeSimulatedRobot(ballInHand(start), 1);
  const Path path{makePose(Vec3(0.5, -0.1, 0.25), Vec3(0.1, 0.2, 0.5)),
                  makePose(Vec3(0.4, 0.2, 0.2), Vec3(0, 0, -0.5))};
  Path whole = path;
  whole.insert(whole.begin(), start);
  const Path dense = densify(whole, 0.001, 0.005);
  ASSERT_FALSE(robot->follow(path));
  while (robot->moving()) {
    const WrenchSample sample = robot->advance();
    double off = 1.0;
    for (const Pose& pose : dense) {
      off = std::min(off, distanceBetween(pose, sample.T_world_object) +
                              angleBetween(pose, sample.T_world_object));
    }
    EXPECT_LT(off, 0.004);
  }
  EXPECT_FALSE(robot->fault());
  settle(robot.get(), 0.1);
  EXPECT_LT(distanceBetween(robot->pose(), path.back()), 2e-4);
  EXPECT_LT(angleBetween(robot->pose(), path.back()), 5e-4);
}

TEST(ArmRobot, isBitIdenticalInTwoRuns) {
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  scenario.wrench_noise = {1.75, 0.1, Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3), 0.17};
  const auto run = [&scenario](std::uint64_t seed) {
    const auto robot = makeSimulatedRobot(scenario, seed);
    (void)robot->follow({makePose(Vec3(0.5, 0.0, 0.2))});
    std::vector<double> record;
    while (robot->moving()) {
      const WrenchSample sample = robot->advance();
      const Vec3& force = sample.wrench.force;
      record.insert(record.end(), force.data(), force.data() + force.size());
      for (const double value : robot->jointPositions()) record.push_back(value);
    }
    return record;
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(ArmRobot, standsStillWithinTwentyMillisecondsOfTheStop) {
  const auto robot = makeSimulatedRobot(ballInHand(makePose(Vec3(0.45, 0.1, 0.2))), 1);
  ASSERT_FALSE(robot->follow({makePose(Vec3(0.5, -0.2, 0.2))}));
  settle(robot.get(), 1.0);
  const Pose at_stop = robot->pose();
  robot->stop();
  EXPECT_FALSE(robot->moving());
  settle(robot.get(), 0.02);
  for (const double velocity : robot->jointVelocities()) EXPECT_LT(std::abs(velocity), 1e-3);
  EXPECT_LT(distanceBetween(robot->pose(), at_stop), 5e-4);
}

TEST(ArmRobot, refusesWhatItCannotDoAndStaysWhereItIs) {
  const auto robot = makeSimulatedRobot(ballInHand(makePose(Vec3(0.45, 0.1, 0.2))), 1);
  const auto failure = robot->follow({makePose(Vec3(2, 0, 0.2))});
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->reason.find("pose 1 of 1"), std::string::npos) << failure->reason;
  EXPECT_FALSE(robot->moving());
  std::vector<double> beyond = robot->jointPositions();
  beyond[2] = 4.0;
  const auto limit = robot->followJoints({robot->jointNames(), {{5.0, beyond, {}}}});
  ASSERT_TRUE(limit);
  EXPECT_NE(limit->reason.find("elbow_joint"), std::string::npos);
  EXPECT_THROW((void)robot->followJoints({{"elbow_joint"}, {{1.0, {0.0}, {}}}}), InputError);
  EXPECT_THROW(robot->place(makePose(Vec3(2, 0, 0.2))), InputError);
  EXPECT_FALSE(robot->canBePlaced());
}

TEST(ArmRobot, neverMovesFasterThanItsJointsCan) {
  const auto robot = makeSimulatedRobot(ballInHand(makePose(Vec3(0.45, 0.1, 0.4))), 1);
  std::vector<double> far = robot->jointPositions();
  far[0] += 1.0;
  ASSERT_FALSE(robot->followJoints({robot->jointNames(), {{0.05, far, {}}}}));
  double fastest = 0.0;
  for (int i = 0; i < 200; ++i) {
    robot->advance();
    for (const double velocity : robot->jointVelocities()) {
      fastest = std::max(fastest, std::abs(velocity));
    }
  }
  EXPECT_LE(fastest, M_PI + 0.01);
  ASSERT_TRUE(robot->fault());
  EXPECT_NE(robot->fault()->reason.find("shoulder_pan_joint"), std::string::npos);
}

void waitForGripper(SimulatedRobot* robot) {
  while (robot->gripper()->moving) robot->advance();
  settle(robot, 0.3);
}

// The object falls onto the table below, and is taken up again.
TEST(ArmRobot, opensAndClosesItsGripper) {
  constexpr double kWeight = 9.80665 * 0.5;
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  scenario.environment = {{BoxShape{Vec3(0.2, 0.2, 0.02)}, makePose(Vec3(0.45, 0.1, 0.158))}};
  const auto robot = makeSimulatedRobot(scenario, 1);
  settle(robot.get(), 0.1);
  const double loaded = robot->reading().wrench.force.norm();
  ASSERT_TRUE(robot->gripper());
  const double grasp = robot->gripper()->position;
  EXPECT_TRUE(robot->gripper()->holds_object);
  // A box of 3 cm: the pads are 3 cm apart where sin(0.7185 - q) 0.0571 = 0.015 - 0.0049.
  EXPECT_NEAR(grasp, 0.7185 - std::asin((0.015 - 0.0049) / 0.0571), 5e-3);

  ASSERT_FALSE(robot->moveGripper(0.0));
  EXPECT_TRUE(robot->follow({scenario.start}));  // refused meanwhile
  waitForGripper(robot.get());
  EXPECT_FALSE(robot->gripper()->holds_object);
  EXPECT_EQ(robot->gripper()->position, 0.0);
  EXPECT_NEAR(robot->reading().wrench.force.norm(), loaded - kWeight, 0.05);

  ASSERT_FALSE(robot->moveGripper(0.8));
  waitForGripper(robot.get());
  EXPECT_TRUE(robot->gripper()->holds_object);
  EXPECT_NEAR(robot->gripper()->position, grasp, 5e-3);
  ASSERT_FALSE(robot->follow({makePose(Vec3(0.45, 0.1, 0.3))}));
  while (robot->moving()) robot->advance();
  settle(robot.get(), 0.3);
  EXPECT_NEAR(robot->reading().wrench.force.norm(), loaded, 0.05);
}

TEST(ArmRobot, closesWithoutAnObjectThatIsNotThere) {
  const Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.5)));  // nothing below
  const auto robot = makeSimulatedRobot(scenario, 1);
  ASSERT_FALSE(robot->moveGripper(0.0));
  waitForGripper(robot.get());
  settle(robot.get(), 1.0);
  ASSERT_FALSE(robot->moveGripper(0.8));
  waitForGripper(robot.get());
  EXPECT_FALSE(robot->gripper()->holds_object);
  EXPECT_EQ(robot->gripper()->position, 0.8);
  robot->place(scenario.start);
  EXPECT_TRUE(robot->gripper()->holds_object);
}

// An arm with a longer forearm: the simulator and the kinematics read both from the URDF, and
// agree.
TEST(ArmRobot, isBuiltFromAnyUrdfOfSixJoints) {
  std::ifstream stream(SMORE_SOURCE_DIR "/urdf/ur5e_2f85.urdf");
  std::stringstream text;
  text << stream.rdbuf();
  const std::string longer =
      std::regex_replace(text.str(), std::regex("-0.3922 0 0.1333"), "-0.45 0.01 0.12");
  ASSERT_NE(longer, text.str());
  const UrdfModel urdf = parseUrdf(longer, "longer");
  const Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  const auto robot = makeSimulatedArm(scenario, urdf, 1);
  const Pose target = makePose(Vec3(0.5, -0.1, 0.25), Vec3(0.1, 0.2, 0.5));
  ASSERT_FALSE(robot->follow({target}));
  while (robot->moving()) robot->advance();
  settle(robot.get(), 0.2);
  EXPECT_LT(distanceBetween(robot->pose(), target), 2e-4);
  const ArmModel arm(urdf);
  EXPECT_LT(distanceBetween(arm.toolPose(toJointVector(robot->jointPositions())),
                            target * robot->T_sensor_object().inverse()),
            2e-4);
  const ArmModel ur5e(armUrdf(RobotKind::kUr5e));
  EXPECT_GT(distanceBetween(ur5e.toolPose(toJointVector(robot->jointPositions())),
                            arm.toolPose(toJointVector(robot->jointPositions()))),
            0.01);
}

TEST(ArmRobot, needsStartAndGoalWithinReach) {
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  scenario.goal = makePose(Vec3(1.2, 0.1, 0.2));
  EXPECT_THROW(makeSimulatedRobot(scenario, 1), InputError);
  EXPECT_THROW(makeSimulatedRobot(ballInHand(scenario.goal), 1), InputError);
}

TEST(ArmRobot, needsAnObjectThatTheGripperCanHold) {
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  scenario.object[0].geometry = BoxShape{Vec3(0.03, 0.1, 0.07)};
  EXPECT_THROW(makeSimulatedRobot(scenario, 1), InputError);
  scenario.object.erase(scenario.object.begin());
  EXPECT_THROW(makeSimulatedRobot(scenario, 1), InputError);
}

// Why the arm is refused where one place of its description reads otherwise.
std::string problemOfChangedArm(const std::string& pattern, const std::string& replacement) {
  std::ifstream built_in(SMORE_SOURCE_DIR "/urdf/ur5e_2f85.urdf");
  std::stringstream text;
  text << built_in.rdbuf();
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  scenario.robot = RobotKind::kUrdf;
  scenario.robot_urdf = testing::TempDir() + "changed_arm.urdf";
  std::ofstream(scenario.robot_urdf) << std::regex_replace(
      text.str(), std::regex(pattern), replacement, std::regex_constants::format_first_only);
  return refusalOf([&] { return makeSimulatedRobot(scenario, 1); });
}

// Once a null pointer: what a finger's joint lacks is told.
TEST(ArmRobot, TellsWhatTheDescriptionOfItsFingersLacks) {
  const std::string problem = problemOfChangedArm(
      "(name=\"finger_joint\" type=\")revolute([^]*?)<limit[^>]*/>", "$1continuous$2");
  EXPECT_NE(problem.find("finger_joint has no limits"), std::string::npos) << problem;
}

TEST(ArmRobot, TellsOfAJointBesideTheArm) {
  const std::string problem = problemOfChangedArm(
      "</robot>",
      "<link name=\"camera\"><inertial><mass value=\"0.1\"/><inertia ixx=\"1e-4\" iyy=\"1e-4\" "
      "izz=\"1e-4\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link><joint name=\"pan_joint\" "
      "type=\"revolute\"><parent link=\"shoulder_link\"/><child link=\"camera\"/><axis xyz=\"0 0 "
      "1\"/>"
      "<limit lower=\"-1\" upper=\"1\" velocity=\"1\" effort=\"1\"/></joint></robot>");
  EXPECT_NE(problem.find("pan_joint moves, but does not lie between"), std::string::npos)
      << problem;
}

TEST(ArmRobot, TellsOfFingersThatCannotMove) {
  const std::string problem =
      problemOfChangedArm("(name=\"finger_joint\"[^]*?velocity=)\"[^\"]*\"", "$1\"0\"");
  EXPECT_NE(problem.find("finger_joint: an upper limit of 0.8"), std::string::npos) << problem;
}

// A joint without torque would let the arm fall.
TEST(ArmRobot, TellsOfAJointWithoutTorque) {
  const std::string problem =
      problemOfChangedArm("(name=\"elbow_joint\"[^]*?effort=)\"[^\"]*\"", "$1\"0\"");
  EXPECT_NE(problem.find("elbow_joint: an effort of 0"), std::string::npos) << problem;
}

}  // namespace
}  // namespace smore
