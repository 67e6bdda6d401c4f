// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include "smore/kinematics/inverse_kinematics.h"

namespace smore {
namespace {

JointVector randomConfiguration(std::mt19937* random) {
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  return JointVector::NullaryExpr([&] { return angle(*random); });
}

double difference(const JointVector& a, const JointVector& b) {
  return (a - b)
      .unaryExpr([](double angle) { return std::abs(std::remainder(angle, 2.0 * M_PI)); })
      .maxCoeff();
}

double residual(const ArmModel& arm, const JointVector& q, const Pose& target) {
  const Pose pose = arm.toolPose(q);
  return distanceBetween(pose, target) + angleBetween(pose, target);
}

class UrArm : public testing::TestWithParam<RobotKind> {};

INSTANTIATE_TEST_SUITE_P(Arms, UrArm,
                         testing::Values(RobotKind::kUr3e, RobotKind::kUr5e, RobotKind::kUr10e,
                                         RobotKind::kUr16e),
                         [](const auto& arm) { return robotName(arm.param); });

// Every answer is right, and the configuration that the pose was made from is among them.
TEST_P(UrArm, meetsTenThousandRandomPoses) {
  const ArmModel arm(armUrdf(GetParam()));
  const InverseKinematics inverse(&arm);
  std::mt19937 random(1);
  for (int i = 0; i < 10000; ++i) {
    const JointVector q = randomConfiguration(&random);
    const Pose target = arm.toolPose(q);
    const std::vector<JointVector> branches = inverse.branches(target);
    double nearest = 10.0;
    for (const JointVector& branch : branches) {
      EXPECT_LT(residual(arm, branch, target), 1e-6);
      EXPECT_LE(branch.cwiseAbs().maxCoeff(), M_PI + 1e-12);
      nearest = std::min(nearest, difference(branch, q));
    }
    EXPECT_LE(branches.size(), 8U);
    // Close to a singularity many configurations meet the pose within the tolerance.
    if (inverse.singularity(q) > 1e-3) {
      EXPECT_LT(nearest, 1e-4);
    }
  }
}

TEST(InverseKinematics, thereAreEightBranchesInTheMidstOfTheWorkspace) {
  const ArmModel arm(armUrdf(RobotKind::kUr5e));
  const Pose target = makePose(Vec3(0.45, 0.1, 0.35), Vec3(M_PI - 0.2, 0.1, 0.3));
  EXPECT_EQ(InverseKinematics(&arm).branches(target).size(), 8U);
}

TEST(InverseKinematics, posesBeyondTheReachHaveNoAnswer) {
  const ArmModel arm(armUrdf(RobotKind::kUr5e));
  const InverseKinematics inverse(&arm);
  EXPECT_TRUE(inverse.branches(makePose(Vec3(1.2, 0, 0.3))).empty());
  EXPECT_TRUE(inverse.branches(makePose(Vec3(0.05, 0, 0.5), Vec3(M_PI, 0, 0))).empty());
}

// The arm of the file with its joints' origins off by what a calibration finds.
UrdfModel calibrated() {
  std::ifstream stream(SMORE_SOURCE_DIR "/urdf/ur5e_2f85.urdf");
  std::stringstream text;
  text << stream.rdbuf();
  const std::string shifted =
      std::regex_replace(text.str(), std::regex("xyz=\"-0.425 0 0\"/>\\s*<axis"),
                         "xyz=\"-0.4243 0.0004 0.0008\" "
                         "rpy=\"0.002 -0.001 0.003\"/><axis");
  return parseUrdf(shifted, "calibrated");
}

TEST(InverseKinematics, meetsACalibratedArmExactly) {
  const ArmModel nominal(armUrdf(RobotKind::kUr5e));
  const ArmModel arm(calibrated());
  const InverseKinematics inverse(&arm);
  std::mt19937 random(3);
  ASSERT_GT(
      distanceBetween(arm.toolPose(JointVector::Zero()), nominal.toolPose(JointVector::Zero())),
      1e-4);
  int regular = 0;
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const JointVector q = randomConfiguration(&random);
    if (inverse.singularity(q) < 0.05) continue;
    ++regular;
    const Pose target = arm.toolPose(q);
    const auto branches = inverse.branches(target);
    for (const JointVector& branch : branches) EXPECT_LT(residual(arm, branch, target), 1e-6);
    met += std::any_of(branches.begin(), branches.end(),
                       [&q](const JointVector& branch) { return difference(branch, q) < 1e-4; });
  }
  EXPECT_GT(regular, 100);
  EXPECT_EQ(met, regular);
}

// A wrist whose three axes meet, of other proportions: no closed form here.
const char* const kOtherArm = R"(<robot name="other"><link name="base_link"/>
<link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/>
<link name="tool0_controller"/><link name="grasp_frame"/>
<joint name="j1" type="revolute"><parent link="base_link"/><child link="a"/><origin xyz="0 0 0.3"/>
  <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
<joint name="j2" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0.05 0 0.1"/>
  <axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
<joint name="j3" type="revolute"><parent link="b"/><child link="c"/><origin xyz="0 0 0.4"/>
  <axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
<joint name="j4" type="revolute"><parent link="c"/><child link="d"/><origin xyz="0.1 0 0.05"/>
  <axis xyz="1 0 0"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
<joint name="j5" type="revolute"><parent link="d"/><child link="e"/><origin xyz="0.3 0 0"/>
  <axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
<joint name="j6" type="revolute"><parent link="e"/><child link="tool0_controller"/>
  <origin xyz="0.08 0 0"/><axis xyz="1 0 0"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
<joint name="g" type="fixed"><parent link="tool0_controller"/><child link="grasp_frame"/></joint>
</robot>)";

TEST(InverseKinematics, findsAnswersForAnArmOfAnotherBuild) {
  const ArmModel arm(parseUrdf(kOtherArm, "other"));
  ASSERT_FALSE(urGeometry(arm).has_value());
  const InverseKinematics inverse(&arm);
  std::mt19937 random(4);
  for (int i = 0; i < 30; ++i) {
    const Pose target = arm.toolPose(randomConfiguration(&random));
    const auto branches = inverse.branches(target);
    EXPECT_FALSE(branches.empty());
    for (const JointVector& branch : branches) EXPECT_LT(residual(arm, branch, target), 1e-6);
  }
}

}  // namespace
}  // namespace smore
