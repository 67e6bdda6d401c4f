// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "smore/kinematics/arm_model.h"
#include "smore/kinematics/described_arm.h"
#include "smore/simulation/calibrated_arm.h"

namespace smore {
namespace {

Scenario scenarioWith(RobotKind arm) {
  Scenario scenario;
  scenario.robot = arm;
  return scenario;
}

JointVector configuration() {
  JointVector q;
  q << 0.3, -1.2, 1.5, -1.8, -1.5, 0.7;
  return q;
}

Pose toolOf(const UrdfModel& arm) { return ArmModel(arm).toolPose(configuration()); }

TEST(CalibratedArm, isOffTheNominalOneByMillimetresAndByTheSeed) {
  const Pose nominal = toolOf(armUrdf(RobotKind::kUr5e));
  double squares = 0.0;
  for (int seed = 1; seed <= 20; ++seed) {
    squares += std::pow(
        distanceBetween(toolOf(calibratedArm(scenarioWith(RobotKind::kUr5e), 1e-3, seed)), nominal),
        2);
  }
  // Six joints, three axes of 1 mm each, and turns of 1 mrad at up to 0.9 m.
  EXPECT_GT(std::sqrt(squares / 20), 0.002);
  EXPECT_LT(std::sqrt(squares / 20), 0.006);
  EXPECT_EQ(gapBetween(toolOf(calibratedArm(scenarioWith(RobotKind::kUr5e), 1e-3, 7)),
                       toolOf(calibratedArm(scenarioWith(RobotKind::kUr5e), 1e-3, 7))),
            0.0);
  EXPECT_EQ(gapBetween(toolOf(calibratedArm(scenarioWith(RobotKind::kUr5e), 0.0, 7)), nominal),
            0.0);
}

// A cover that is fixed between two joints.
TEST(CalibratedArm, isDescribedWithWhatIsFixedBetweenItsJoints) {
  std::ifstream stream(SMORE_SOURCE_DIR "/urdf/ur5e_2f85.urdf");
  std::stringstream text;
  text << stream.rdbuf();
  const std::string covered = std::regex_replace(
      text.str(), std::regex("(<joint name=\"wrist_1_joint\"[^]*?)<parent link=\"forearm_link\"/>"),
      "<link name=\"cover\"/><joint name=\"cover_joint\" type=\"fixed\"><parent "
      "link=\"forearm_link\"/><child link=\"cover\"/><origin xyz=\"0 0 0.01\"/></joint>\n"
      "$1<parent link=\"cover\"/>",
      std::regex_constants::format_first_only);
  const UrdfModel arm = parseUrdf(covered, "covered");
  const UrdfModel read = parseUrdf(jointsDescription(arm), "jointsDescription");
  EXPECT_EQ(read->getLink("cover")->getParent()->name, "forearm_link");
  EXPECT_EQ(read->getRoot()->name, arm->getJoint("shoulder_pan_joint")->parent_link_name);
}

TEST(CalibratedArm, isDescribedExactly) {
  for (const RobotKind kind : {RobotKind::kUr3e, RobotKind::kUr16e}) {
    const UrdfModel arm = calibratedArm(scenarioWith(kind), 2e-3, 5);
    const UrdfModel read = parseUrdf(jointsDescription(arm), "jointsDescription");
    EXPECT_LT(gapBetween(toolOf(describedArm(scenarioWith(kind), read)), toolOf(arm)), 1e-9);
    for (const char* link : {"shoulder_link", "forearm_link", "wrist_2_link"}) {
      const auto& seen = read->getLink(link)->visual_array;
      const auto& whole = arm->getLink(link)->visual_array;
      ASSERT_EQ(seen.size(), whole.size()) << link;
      ASSERT_FALSE(seen.empty()) << link;
      EXPECT_EQ(seen[0]->geometry->type, whole[0]->geometry->type) << link;
      EXPECT_NEAR(seen[0]->origin.position.z, whole[0]->origin.position.z, 1e-9) << link;
      EXPECT_EQ(seen[0]->material->color.r, whole[0]->material->color.r) << link;
    }
  }
}

}  // namespace
}  // namespace smore
