// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>

#include "../common/refusal.h"
#include "smore/common/result.h"
#include "smore/kinematics/arm_model.h"

namespace smore {
namespace {

JointVector randomConfiguration(std::mt19937* random) {
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  return JointVector::NullaryExpr([&] { return angle(*random); });
}

// The maker's tables: d1, a2, a3, d4, d5, d6 [m], and the masses of the six links [kg].
struct Table {
  RobotKind arm;
  std::array<double, 6> lengths;
  std::array<double, 6> masses;
};

const Table kTables[] = {
    {RobotKind::kUr3e,
     {0.15185, -0.24355, -0.2132, 0.13105, 0.08535, 0.0921},
     {1.98, 3.4445, 1.437, 0.871, 0.805, 0.261}},
    {RobotKind::kUr5e,
     {0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996},
     {3.761, 8.058, 2.846, 1.37, 1.3, 0.365}},
    {RobotKind::kUr10e,
     {0.1807, -0.6127, -0.57155, 0.17415, 0.11985, 0.11655},
     {7.369, 13.051, 3.989, 2.1, 1.98, 0.615}},
    {RobotKind::kUr16e,
     {0.1807, -0.4784, -0.36, 0.17415, 0.11985, 0.11655},
     {7.369, 10.45, 4.321, 2.18, 2.033, 0.907}},
};

// A table multiplied out.
Pose byTable(const Table& table, const JointVector& q) {
  const auto& [d1, a2, a3, d4, d5, d6] = table.lengths;
  const double rows[kArmJoints][3] = {{0, d1, M_PI_2}, {a2, 0, 0},       {a3, 0, 0},
                                      {0, d4, M_PI_2}, {0, d5, -M_PI_2}, {0, d6, 0}};
  Pose pose = Pose::Identity();
  for (int i = 0; i < kArmJoints; ++i) {
    const auto& [a, d, alpha] = rows[i];
    pose = pose * Eigen::AngleAxisd(q[i], Vec3::UnitZ()) * Eigen::Translation3d(a, 0, d) *
           Eigen::AngleAxisd(alpha, Vec3::UnitX());
  }
  return pose;
}

class UrArm : public testing::TestWithParam<Table> {
 protected:
  const UrdfModel urdf_ = armUrdf(GetParam().arm);
  const ArmModel arm_{urdf_};
};

INSTANTIATE_TEST_SUITE_P(Arms, UrArm, testing::ValuesIn(kTables),
                         [](const auto& table) { return robotName(table.param.arm); });

TEST_P(UrArm, isThatOfItsFile) {
  const std::string file =
      SMORE_SOURCE_DIR "/urdf/" + robotName(GetParam().arm) + std::string("_2f85.urdf");
  const KinematicTree read(loadUrdf(file), "base_link");
  EXPECT_EQ(read.links().size(), arm_.tree().links().size());
  EXPECT_EQ(read.jointNames(), arm_.tree().jointNames());
}

TEST_P(UrArm, hasTheForwardKinematicsOfTheMakersTable) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const JointVector q = randomConfiguration(&random);
    // The table starts from the frame `base`, turned by pi about z.
    const Pose expected = makePose(Vec3::Zero(), Vec3(0, 0, M_PI)) * byTable(GetParam(), q);
    EXPECT_TRUE(arm_.toolPose(q).isApprox(expected, 1e-9));
  }
}

TEST_P(UrArm, hasTheMassesOfTheMakersTable) {
  const std::array<const char*, kArmJoints> links{"shoulder_link", "upper_arm_link",
                                                  "forearm_link",  "wrist_1_link",
                                                  "wrist_2_link",  "wrist_3_link"};
  for (std::size_t i = 0; i < links.size(); ++i) {
    EXPECT_NEAR(urdf_->getLink(links[i])->inertial->mass, GetParam().masses[i], 1e-9) << links[i];
  }
}

TEST_P(UrArm, hasTheJointsAndFramesOfTheDriver) {
  const std::array<std::string, kArmJoints> names{"shoulder_pan_joint", "shoulder_lift_joint",
                                                  "elbow_joint",        "wrist_1_joint",
                                                  "wrist_2_joint",      "wrist_3_joint"};
  EXPECT_EQ(arm_.jointNames(), names);
  for (const char* frame : {"base_link", "base", "tool0", "tool0_controller", "grasp_frame"}) {
    EXPECT_GE(arm_.tree().linkIndex(frame), 0) << frame;
  }
  EXPECT_THROW(arm_.tree().linkIndex("no_such_link"), InputError);
}

// Shapes of neighbouring links reach one another: an arm without a gap.
TEST_P(UrArm, hasNoGapBetweenNeighbouringLinks) {
  constexpr double kJoint = 0.01;  // what stands between two housings [m]
  const std::vector<Pose> poses = arm_.linkPoses(JointVector::Zero());
  std::optional<Bounds> before;
  for (const char* name : {"base_link_inertia", "shoulder_link", "upper_arm_link", "forearm_link",
                           "wrist_1_link", "wrist_2_link", "wrist_3_link", "gripper_base_link"}) {
    std::vector<Shape> shapes = collisionShapes(urdf_, name);
    const int index = arm_.tree().linkIndex(name);
    for (Shape& shape : shapes) shape.pose = poses[static_cast<std::size_t>(index)] * shape.pose;
    const Bounds bounds = boundsOf(shapes);
    if (before) {
      const Vec3 gap = (bounds.min - before->max).cwiseMax(before->min - bounds.max);
      EXPECT_LT(gap.maxCoeff(), kJoint) << name;
    }
    before = bounds;
  }
}

TEST(Urdf, theCartesianRobotHasNoDescription) {
  EXPECT_THROW(armUrdf(RobotKind::kCartesian), InputError);
}

TEST(Urdf, jacobianIsTheDerivativeOfTheToolPose) {
  const ArmModel arm(armUrdf(RobotKind::kUr5e));
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

TEST(Urdf, theGripperHasTheMassOfItsDataSheet) {
  const UrdfModel urdf = armUrdf(RobotKind::kUr5e);
  const KinematicTree gripper(urdf, "tool0_controller");
  double mass = 0.0;
  for (const TreeLink& link : gripper.links()) {
    const auto& inertial = urdf->getLink(link.name)->inertial;
    if (inertial) mass += inertial->mass;
  }
  EXPECT_NEAR(mass, 0.925, 1e-9);
}

// Extent along an axis of the gripper's collision shapes at a finger angle, in the tool frame.
std::pair<double, double> extent(int axis, double finger, const std::string& only = "") {
  const UrdfModel urdf = armUrdf(RobotKind::kUr5e);
  const KinematicTree gripper(urdf, "tool0_controller");
  const std::vector<Pose> poses = gripper.linkPoses({finger});
  std::pair<double, double> range{1.0, -1.0};
  for (size_t i = 0; i < poses.size(); ++i) {
    const std::string& name = gripper.links()[i].name;
    if (name.find(only) == std::string::npos) continue;
    std::vector<Shape> shapes = collisionShapes(urdf, name);
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

TEST(Urdf, whatIsBadInADescriptionIsToldWithItsFile) {
  const auto bad = [](const std::string& in_link, const std::string& joint) {
    return parseUrdf(R"(<robot name="bad"><link name="base_link">)" + in_link +
                         R"(</link><link name="hand"/><joint name="wrist" type=")" + joint +
                         R"("><parent link="base_link"/><child link="hand"/></joint></robot>)",
                     "my_arm.urdf");
  };
  const auto mesh = R"(<collision><geometry><mesh filename="a.stl"/></geometry></collision>)";
  const auto begins = [](const std::string& problem, const std::string& words) {
    EXPECT_EQ(problem.find("my_arm.urdf: " + words), 0U) << problem;
  };
  begins(refusalOf([&] { return collisionShapes(bad(mesh, "fixed"), "base_link"); }),
         "link base_link: ");
  begins(refusalOf([&] { return KinematicTree(bad("", "floating"), "base_link"); }),
         "joint wrist: ");
  begins(refusalOf([&] { return KinematicTree(bad("", "fixed"), "base"); }), "there is no link");
  begins(refusalOf([&] { return ArmModel(bad("", "fixed")); }), "there is no link");
  ArmFrames frames;
  frames.tool = "hand";
  begins(refusalOf([&] { return ArmModel(bad("", "fixed"), frames); }), "there are 0 moving");
}

// Also one that mimics what is not there.
TEST(Urdf, aJointOfTheArmThatMimicsAnotherIsRefused) {
  std::ifstream stream(SMORE_SOURCE_DIR "/urdf/ur5e_2f85.urdf");
  std::stringstream text;
  text << stream.rdbuf();
  const std::string own = "<joint name=\"wrist_3_joint\" type=\"revolute\">";
  for (const std::string other : {"wrist_2_joint", "typo"}) {
    std::string changed = text.str();
    const size_t at = changed.find(own);
    ASSERT_NE(at, std::string::npos);
    changed.insert(at + own.size(), "<mimic joint=\"" + other + "\"/>");
    const UrdfModel urdf = parseUrdf(changed, "my_arm.urdf");
    const std::string problem = refusalOf([&] { return ArmModel(urdf); });
    EXPECT_NE(problem.find("wrist_3_joint: mimics " + other), std::string::npos) << problem;
  }
}

TEST(Urdf, badDescriptionsAreRefusedWithTheirReason) {
  EXPECT_THROW(parseUrdf("<robot", "broken"), InputError);
  EXPECT_THROW(loadUrdf("/nowhere/arm.urdf"), InputError);
  ArmFrames frames;
  frames.tool = "forearm_link";
  EXPECT_THROW(ArmModel(armUrdf(RobotKind::kUr5e), frames), InputError);
  frames.tool = "no_such_link";
  EXPECT_THROW(ArmModel(armUrdf(RobotKind::kUr5e), frames), InputError);
}

}  // namespace
}  // namespace smore
