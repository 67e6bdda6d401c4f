// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "smore/common/result.h"
#include "smore/kinematics/arm_model.h"

namespace smore {
namespace {

const char* const kUrdfFile = SMORE_SOURCE_DIR "/urdf/ur5e_2f85.urdf";

JointVector randomConfiguration(std::mt19937* random) {
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  JointVector q;
  for (double& value : q) value = angle(*random);
  return q;
}

// The maker's table (a, d, alpha of the UR5e's joints), multiplied out.
Pose byTable(const JointVector& q) {
  constexpr double kTable[kArmJoints][3] = {{0, 0.1625, M_PI_2},  {-0.425, 0, 0},
                                            {-0.3922, 0, 0},      {0, 0.1333, M_PI_2},
                                            {0, 0.0997, -M_PI_2}, {0, 0.0996, 0}};
  Pose pose = Pose::Identity();
  for (int i = 0; i < kArmJoints; ++i) {
    const auto& [a, d, alpha] = kTable[i];
    pose = pose * Eigen::AngleAxisd(q[i], Vec3::UnitZ()) * Eigen::Translation3d(a, 0, d) *
           Eigen::AngleAxisd(alpha, Vec3::UnitX());
  }
  return pose;
}

TEST(Urdf, theBuiltInArmIsThatOfTheFile) {
  const KinematicTree file(loadUrdf(kUrdfFile), "base_link");
  const KinematicTree built_in(ur5eUrdf(), "base_link");
  ASSERT_EQ(file.links().size(), built_in.links().size());
  EXPECT_EQ(file.jointNames(), built_in.jointNames());
}

TEST(Urdf, forwardKinematicsAreThoseOfTheMakersTable) {
  const ArmModel arm(ur5eUrdf());
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const JointVector q = randomConfiguration(&random);
    // The table starts from the frame `base`, turned by pi about z.
    const Pose expected = makePose(Vec3::Zero(), Vec3(0, 0, M_PI)) * byTable(q);
    EXPECT_TRUE(arm.toolPose(q).isApprox(expected, 1e-9));
  }
}

TEST(Urdf, jacobianIsTheDerivativeOfTheToolPose) {
  const ArmModel arm(ur5eUrdf());
  std::mt19937 random(2);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 100; ++i) {
    const JointVector q = randomConfiguration(&random);
    const ArmJacobian jacobian = arm.jacobian(q);
    for (int joint = 0; joint < kArmJoints; ++joint) {
      const Pose before = arm.toolPose(q - kStep * JointVector::Unit(joint));
      const Pose after = arm.toolPose(q + kStep * JointVector::Unit(joint));
      const Eigen::AngleAxisd turn(after.linear() * before.linear().transpose());
      const Vec3 linear = (after.translation() - before.translation()) / (2.0 * kStep);
      const Vec3 angular = turn.angle() * turn.axis() / (2.0 * kStep);
      EXPECT_LT((jacobian.col(joint).head<3>() - linear).norm(), 1e-6);
      EXPECT_LT((jacobian.col(joint).tail<3>() - angular).norm(), 1e-6);
    }
  }
}

TEST(Urdf, jointsAndFramesAreThoseOfTheDriver) {
  const ArmModel arm(ur5eUrdf());
  const std::array<std::string, kArmJoints> names{"shoulder_pan_joint", "shoulder_lift_joint",
                                                  "elbow_joint",        "wrist_1_joint",
                                                  "wrist_2_joint",      "wrist_3_joint"};
  EXPECT_EQ(arm.jointNames(), names);
  for (const char* frame : {"base_link", "base", "tool0", "tool0_controller", "grasp_frame"}) {
    EXPECT_GE(arm.tree().linkIndex(frame), 0) << frame;
  }
  EXPECT_THROW(arm.tree().linkIndex("no_such_link"), InputError);
}

TEST(Urdf, massesAreThoseOfTheDataSheets) {
  double arm = 0.0;
  double gripper = 0.0;
  const UrdfModel urdf = ur5eUrdf();
  const KinematicTree carried(urdf, "tool0_controller");
  for (const auto& [name, link] : urdf->links_) {
    if (!link->inertial || name == "base_link_inertia") continue;
    const auto& links = carried.links();
    const bool distal = std::any_of(links.begin(), links.end(),
                                    [&name = name](const auto& l) { return l.name == name; });
    (distal ? gripper : arm) += link->inertial->mass;
  }
  EXPECT_NEAR(arm, 3.761 + 8.058 + 2.846 + 1.37 + 1.3 + 0.365, 1e-9);
  EXPECT_NEAR(gripper, 0.925, 1e-9);
}

// Extent along an axis of the gripper's collision shapes at a finger angle, in the tool frame.
std::pair<double, double> extent(int axis, double finger, const std::string& only = "") {
  const UrdfModel urdf = ur5eUrdf();
  const KinematicTree gripper(urdf, "tool0_controller");
  const std::vector<Pose> poses = gripper.linkPoses({finger});
  std::pair<double, double> range{1.0, -1.0};
  for (size_t i = 0; i < poses.size(); ++i) {
    const std::string& name = gripper.links()[i].name;
    if (name.find(only) == std::string::npos) continue;
    std::vector<Shape> shapes = collisionShapes(*urdf->getLink(name));
    if (shapes.empty()) continue;
    for (Shape& shape : shapes) shape.pose = poses[i] * shape.pose;
    const Bounds bounds = boundsOf(shapes);
    range = {std::min(range.first, bounds.min[axis]), std::max(range.second, bounds.max[axis])};
  }
  return range;
}

TEST(Urdf, gripperHasTheSizeAndStrokeOfItsDataSheet) {
  EXPECT_NEAR(extent(2, 0.8).second, 0.1628, 1e-3);
  const auto open = extent(1, 0.0);
  EXPECT_NEAR(open.second - open.first, 0.1486, 0.006);
  EXPECT_NEAR(2.0 * extent(1, 0.0, "left_finger").first, 0.085, 1e-3);
  EXPECT_NEAR(2.0 * extent(1, 0.8, "left_finger").first, 0.0, 1e-3);
}

TEST(Urdf, badDescriptionsAreRefusedWithTheirReason) {
  EXPECT_THROW(parseUrdf("<robot", "broken"), InputError);
  EXPECT_THROW(loadUrdf("/nowhere/arm.urdf"), InputError);
  ArmFrames frames;
  frames.tool = "forearm_link";
  EXPECT_THROW(ArmModel(ur5eUrdf(), frames), InputError);
  frames.tool = "no_such_link";
  EXPECT_THROW(ArmModel(ur5eUrdf(), frames), InputError);
}

}  // namespace
}  // namespace smore
