// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "../common/refusal.h"
#include "smore/kinematics/arm_model.h"
#include "smore/kinematics/described_arm.h"

namespace smore {
namespace {

Scenario scenarioWith(RobotKind arm) {
  Scenario scenario;
  scenario.robot = arm;
  return scenario;
}

// As ur_description writes it: meshes, no gripper, links that are not ours.
std::string description() {
  std::ifstream stream(SMORE_SOURCE_DIR "/test/data/robot_description/ur5e_calibrated.urdf");
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string replaced(const std::string& from, const std::string& to) {
  const std::string text = description();
  EXPECT_NE(text.find(from), std::string::npos) << from;
  return std::regex_replace(text, std::regex(from), to);
}

std::string problemOf(RobotKind arm, const std::string& xml) {
  return refusalOf(
      [&] { return describedArm(scenarioWith(arm), parseUrdf(xml, "the test's description")); });
}

// The chain of the description, multiplied out by the tree of the description itself.
TEST(DescribedArm, standsWhereTheDescriptionHasIt) {
  const UrdfModel described = parseUrdf(description(), "the test's description");
  const KinematicTree theirs(described, "base_link");
  const ArmModel ours(describedArm(scenarioWith(RobotKind::kUr5e), described));
  const ArmModel nominal(armUrdf(RobotKind::kUr5e));
  const auto tool = static_cast<size_t>(theirs.linkIndex("tool0"));
  ASSERT_EQ(theirs.jointNames().size(), 6U);
  JointVector q;
  for (int i = 0; i < 50; ++i) {
    q << std::sin(i), std::cos(2 * i), std::sin(3 * i), 2 * std::sin(5 * i), std::cos(7 * i),
        i / 10.0;
    std::vector<double> positions;
    for (const std::string& name : theirs.jointNames()) {
      const auto& names = ours.jointNames();
      positions.push_back(q[std::find(names.begin(), names.end(), name) - names.begin()]);
    }
    const Pose T_base_tool0 = theirs.linkPoses(positions)[tool];
    EXPECT_LT(gapBetween(ours.toolPose(q), T_base_tool0), 1e-9);
    EXPECT_GT(distanceBetween(nominal.toolPose(q), T_base_tool0), 1e-4);
  }
}

TEST(DescribedArm, keepsTheGripperAndTakesTheLimits) {
  const ArmModel ours(describedArm(scenarioWith(RobotKind::kUr5e), parseUrdf(description(), "")));
  const ArmModel nominal(armUrdf(RobotKind::kUr5e));
  EXPECT_LT(gapBetween(ours.T_tool_grasp(), nominal.T_tool_grasp()), 1e-12);
  EXPECT_EQ(ours.limits()[0].max, 1.5);  // as the description restricts the first joint
}

TEST(DescribedArm, namesBothThatItIsMadeOf) {
  const UrdfModel described = parseUrdf(description(), "the test's description");
  const std::string source = describedArm(scenarioWith(RobotKind::kUr5e), described).source;
  EXPECT_EQ(source, "the built-in ur5e_2f85.urdf with the joints of the test's description");
}

TEST(DescribedArm, refusesAnotherArm) {
  EXPECT_EQ(problemOf(RobotKind::kUr5e, description()), "");
  EXPECT_NE(problemOf(RobotKind::kUr10e, description()).find("nominal arm"), std::string::npos);
  EXPECT_EQ(problemOf(RobotKind::kUr5e, replaced("elbow_joint", "joint_3"))
                .find("the test's description: joint elbow_joint: "),
            0U);
  EXPECT_NE(
      problemOf(RobotKind::kUr5e, replaced("\"forearm_link\"", "\"fore_link\"")).find("it joins"),
      std::string::npos);
}

}  // namespace
}  // namespace smore
