// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/kinematics/arm_motion.h"
#include "smore/kinematics/described_arm.h"
#include "smore/kinematics/joint_commands.h"
#include "smore/kinematics/tool_gap.h"
#include "smore/scenario/scenario.h"

namespace smore {
namespace {

/// The description knows the nominal arm. What is seen is off by something.
class JointCommandsOfAnArm : public testing::Test {
 protected:
  Scenario scenario_ = loadScenario(SMORE_SOURCE_DIR "/config/scenarios/ur5e_one_peg.yaml");
  ArmMotion arm_{armUrdf(RobotKind::kUr5e), armMotionParameters(scenario_)};
  std::unique_ptr<JointCommands> commands_ = makeJointCommands(scenario_);
  JointVector q_ = *arm_.configurationFor(scenario_.start);

  Pose endOf(const JointTrajectory& trajectory) const {
    return arm_.objectPose(toJointVector(trajectory.points.back().positions));
  }
  Pose goal() const { return makePose(Vec3(0.03, -0.02, 0.01), Vec3(0, 0, 0.4)) * scenario_.start; }
};

TEST_F(JointCommandsOfAnArm, goWhereTheDescriptionHasItWhereBothAgree) {
  const auto motion =
      commands_->along(toList(q_), scenario_.start, {scenario_.start, goal()}, Way::kNew);
  ASSERT_TRUE(motion) << motion.reason();
  EXPECT_LT(gapBetween(endOf(*motion), goal()), 1e-6);
  EXPECT_EQ(toolGapProblem(*commands_->toolGap(toList(q_), scenario_.start), kNominalToolGap, ""),
            "");
}

TEST_F(JointCommandsOfAnArm, beginWithoutAJumpWhereTheObjectIsSeenElsewhere) {
  const Pose off = makePose(Vec3(0.004, -0.003, 0.002), Vec3(0.01, 0, -0.01));
  const Pose seen = arm_.objectPose(q_) * off;
  EXPECT_TRUE(commands_->along(toList(q_), seen, {seen}, Way::kNew)->points.empty());
  const Pose target = goal();
  const auto motion = commands_->along(toList(q_), seen, {seen, target}, Way::kNew);
  ASSERT_TRUE(motion) << motion.reason();
  // A gap that stays the same in the object's axes is seen at the target.
  EXPECT_LT(gapBetween(endOf(*motion) * off, target), 1e-6);
}

TEST_F(JointCommandsOfAnArm, nameATcpThatIsSet) {
  const Pose T_flange_tcp = makePose(Vec3(0.0, 0.01, 0.15), Vec3::Zero());
  const Pose T_world_tool = arm_.toolPose(q_);
  const Pose seen = T_world_tool * T_flange_tcp * arm_.T_tool_object();
  const Pose gap = *commands_->toolGap(toList(q_), seen);
  EXPECT_LT(gapBetween(gap, T_flange_tcp), 1e-9);
  const std::string problem = toolGapProblem(gap, kNominalToolGap, commands_->descriptionSource());
  EXPECT_NE(problem.find("(0.0000, 0.0100, 0.1500) m"), std::string::npos) << problem;
  EXPECT_NE(problem.find("TCP"), std::string::npos) << problem;
  EXPECT_NE(problem.find("ur5e_2f85.urdf"), std::string::npos) << problem;
}

TEST_F(JointCommandsOfAnArm, nameATurnedTool) {
  const Pose turned = makePose(Vec3::Zero(), Vec3(0, 0, 0.1));
  EXPECT_NE(toolGapProblem(turned, kNominalToolGap, "").find("turned by 0.1000 rad"),
            std::string::npos);
  EXPECT_EQ(toolGapProblem(makePose(Vec3(0.009, 0, 0), Vec3(0.04, 0, 0)), kNominalToolGap, ""), "");
}

// A TCP of a few millimetres could be a calibration, unless that is known.
TEST_F(JointCommandsOfAnArm, tellASmallTcpFromACalibrationThatIsDescribed) {
  const Pose small = makePose(Vec3(0, 0, 0.004));
  EXPECT_EQ(toolGapProblem(small, commands_->toolGapLimits(), ""), "");
  const UrdfModel arm = armUrdf(RobotKind::kUr5e);
  arm->joints_.at("elbow_joint")->parent_to_joint_origin_transform.position.y += 0.0003;
  const auto calibrated = makeJointCommands(scenario_, describedArm(scenario_, arm));
  const std::string problem = toolGapProblem(small, calibrated->toolGapLimits(), "");
  EXPECT_NE(problem.find("TCP"), std::string::npos) << problem;
  EXPECT_NE(problem.find("allowed are 0.0020 m"), std::string::npos) << problem;
}

TEST_F(JointCommandsOfAnArm, takeRoundingForNoCalibration) {
  const UrdfModel arm = armUrdf(RobotKind::kUr5e);
  arm->joints_.at("elbow_joint")->parent_to_joint_origin_transform.position.y += 1e-6;
  EXPECT_FALSE(isCalibrated(scenario_, describedArm(scenario_, arm)));
}

TEST(JointCommands, ofARobotWithoutDescriptionKnowOfNoGap) {
  const Scenario scenario =
      loadScenario(SMORE_SOURCE_DIR "/config/scenarios/s_shape_two_pegs.yaml");
  const auto commands = makeJointCommands(scenario);
  EXPECT_FALSE(commands->toolGap({0, 0, 0, 0, 0, 0}, Pose::Identity()));
}

}  // namespace
}  // namespace smore
