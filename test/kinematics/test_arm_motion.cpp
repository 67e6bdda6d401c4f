// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "smore/kinematics/arm_motion.h"

namespace smore {
namespace {

// The gripper points down, the object hangs below it.
ArmMotionParameters tableTop() {
  ArmMotionParameters parameters;
  parameters.T_grasp_object = makePose(Vec3(0, 0, 0.05), Vec3(M_PI, 0, 0));
  return parameters;
}

Pose overTable(double x, double y, double yaw = 0.0) {
  return makePose(Vec3(x, y, 0.1), Vec3(0, 0, yaw));
}

const Path kTour{overTable(0.55, 0.2), overTable(0.35, 0.25, 0.6), overTable(0.4, -0.3, -0.8),
                 overTable(0.5, -0.1)};

// Position, velocity and acceleration of the cubic between two points at a time in it.
struct Motion {
  JointVector position, velocity, acceleration;
};
Motion cubic(const JointTrajectoryPoint& a, const JointTrajectoryPoint& b, double time) {
  const double h = b.time - a.time;
  const double s = (time - a.time) / h;
  const JointVector p0 = toJointVector(a.positions), p1 = toJointVector(b.positions);
  const JointVector m0 = h * toJointVector(a.velocities), m1 = h * toJointVector(b.velocities);
  const JointVector c2 = 3.0 * (p1 - p0) - 2.0 * m0 - m1;
  const JointVector c3 = 2.0 * (p0 - p1) + m0 + m1;
  return {p0 + s * (m0 + s * (c2 + s * c3)), (m0 + s * (2.0 * c2 + 3.0 * s * c3)) / h,
          (2.0 * c2 + 6.0 * s * c3) / (h * h)};
}

double distanceToPath(const Pose& pose, const Path& path) {
  double least = 1e9;
  for (const Pose& there : densify(path, 0.001, 0.005)) {
    least = std::min(least, distanceBetween(pose, there) + angleBetween(pose, there));
  }
  return least;
}

TEST(ArmMotion, followsThePathWithinAllLimits) {
  const ArmMotionParameters parameters = tableTop();
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), parameters);
  const auto start = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(start) << start.reason();
  const auto trajectory = motion.trajectory(*start, kTour);
  ASSERT_TRUE(trajectory) << trajectory.reason();
  Path whole = kTour;
  whole.insert(whole.begin(), motion.objectPose(*start));
  const auto& points = trajectory->points;
  ASSERT_GT(points.size(), 100U);
  EXPECT_EQ(toJointVector(points.front().positions), *start);
  EXPECT_EQ(toJointVector(points.front().velocities).norm(), 0.0);
  EXPECT_EQ(toJointVector(points.back().velocities).norm(), 0.0);
  EXPECT_LT(
      distanceBetween(motion.objectPose(toJointVector(points.back().positions)), kTour.back()),
      1e-8);
  constexpr double kStep = 1e-4;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    ASSERT_GT(points[i + 1].time, points[i].time);
    for (const double s : {0.05, 0.35, 0.65, 0.95}) {
      const double time = points[i].time + s * (points[i + 1].time - points[i].time);
      const Motion here = cubic(points[i], points[i + 1], time);
      EXPECT_LE(here.velocity.cwiseAbs().maxCoeff(), M_PI);
      EXPECT_LE(here.acceleration.cwiseAbs().maxCoeff(), 1.001 * parameters.joint_acceleration);
      const Pose before = motion.objectPose(here.position);
      const Pose after = motion.objectPose(here.position + kStep * here.velocity);
      EXPECT_LE(distanceBetween(before, after) / kStep, 1.05 * parameters.linear_speed);
      EXPECT_LE(angleBetween(before, after) / kStep, 1.05 * parameters.angular_speed);
      EXPECT_LT(distanceToPath(before, whole), 0.003);
    }
  }
}

// How far along its straight way the object comes before it comes back [m].
double stepsBack(const ArmMotion& motion, const JointTrajectory& trajectory, const Pose& goal) {
  const auto& points = trajectory.points;
  const Vec3 start = motion.objectPose(toJointVector(points.front().positions)).translation();
  const Vec3 along = (goal.translation() - start).normalized();
  double farthest = 0.0;
  double back = 0.0;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    for (double s = 0.0; s <= 1.0; s += 0.02) {
      const double time = points[i].time + s * (points[i + 1].time - points[i].time);
      const JointVector q = cubic(points[i], points[i + 1], time).position;
      const double way = along.dot(motion.objectPose(q).translation() - start);
      farthest = std::max(farthest, way);
      back = std::max(back, farthest - way);
    }
  }
  return back;
}

// Where an arm stands is a little beside the first pose of a plan, or of its way back.
TEST(ArmMotion, neitherBeginsBackwardsNorPassesTheEndOverAShortStep) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  const auto start = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(start);
  const Pose goal = overTable(0.45, 0.15);
  for (const double step : {1e-6, 1e-5, 1e-4, 1e-3, 2e-3, 2.4e-3, 4e-3}) {
    const Path path = {overTable(0.45, 0.1 + step), overTable(0.45, 0.15 - step), goal};
    const auto trajectory = motion.trajectory(*start, path);
    ASSERT_TRUE(trajectory) << trajectory.reason();
    EXPECT_LT(stepsBack(motion, *trajectory, goal), 2e-5) << step;
  }
}

TEST(ArmMotion, aJointThatStandsNearItsLimitMayMoveAwayFromIt) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  auto q = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(q);
  const double turn = motion.model().limits()[5].max - 0.02 - (*q)[5];
  (*q)[5] += turn;
  const Pose here = motion.objectPose(*q);
  const auto turned = [&here](double angle) {
    return here * Eigen::AngleAxisd(angle, Vec3::UnitZ());
  };
  // The wrist turns as the object does or against it.
  const bool away = bool(motion.trajectory(*q, {here, Pose(turned(0.3))}));
  const auto nearer = motion.trajectory(*q, {here, Pose(turned(away ? -0.01 : 0.01))});
  EXPECT_TRUE(motion.trajectory(*q, {here, Pose(turned(away ? 0.3 : -0.3))}));
  ASSERT_FALSE(nearer);
  EXPECT_NE(nearer.reason().find("wrist_3_joint would pass its limit"), std::string::npos);
}

// Also where a joint stands nearer to its limit than a new way may lead, and is led on to it.
TEST(ArmMotion, canGoBackTheWayItHasCome) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  auto q = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(q);
  const double limit = motion.model().limits()[5].max;
  (*q)[5] = limit - 0.02;
  const Pose here = motion.objectPose(*q);
  (*q)[5] = limit - 0.2;
  const Pose there = motion.objectPose(*q);
  const auto back = motion.trajectory(*q, {there, here}, Way::kBack);
  ASSERT_TRUE(back) << back.reason();
  EXPECT_NEAR(back->points.back().positions[5], limit - 0.02, 1e-6);
  EXPECT_FALSE(motion.trajectory(*q, {there, here}));
  (*q)[5] = limit + 0.01;
  const Pose beyond = motion.objectPose(*q);
  (*q)[5] = limit - 0.2;
  const auto too_far = motion.trajectory(*q, {there, beyond}, Way::kBack);
  ASSERT_FALSE(too_far);
  EXPECT_NE(too_far.reason().find("wrist_3_joint would pass its limit"), std::string::npos);
}

// No jump: along a path that crosses the workspace each configuration is near the one before.
TEST(ArmMotion, staysOnItsBranch) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  const auto start = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(start);
  const auto trajectory = motion.trajectory(*start, kTour);
  ASSERT_TRUE(trajectory);
  for (size_t i = 1; i < trajectory->points.size(); ++i) {
    const JointVector change = toJointVector(trajectory->points[i].positions) -
                               toJointVector(trajectory->points[i - 1].positions);
    EXPECT_LT(change.cwiseAbs().maxCoeff(), 0.1);
  }
}

TEST(ArmMotion, theStartBranchIsAboveTheTableAndReachesTheWantedPoses) {
  ArmMotionParameters parameters = tableTop();
  parameters.wanted = kTour;
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), parameters);
  const auto q = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(q);
  EXPECT_LT(distanceBetween(motion.objectPose(*q), overTable(0.45, 0.1)), 1e-8);
  const ArmCollision collision(armUrdf(RobotKind::kUr5e), &motion.model());
  EXPECT_GT(collision.lowestPoint(*q), 0.0);
  EXPECT_FALSE(collision.collidingLinks(*q).has_value());
  for (const Pose& wanted : kTour) EXPECT_TRUE(motion.trajectory(*q, {wanted}));
}

TEST(ArmMotion, saysWhichPoseIsOutOfReach) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  const auto start = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(start);
  const auto trajectory = motion.trajectory(*start, {overTable(0.5, 0.2), overTable(1.5, 0.2)});
  ASSERT_FALSE(trajectory);
  EXPECT_NE(trajectory.reason().find("pose 2 of 2"), std::string::npos) << trajectory.reason();
  const auto beyond = motion.configurationFor(overTable(1.5, 0.2));
  ASSERT_FALSE(beyond);
  EXPECT_NE(beyond.reason().find("reach"), std::string::npos) << beyond.reason();
}

TEST(ArmMotion, refusesToTurnAJointBeyondItsLimit) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  const auto start = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(start);
  Path turns;
  for (int i = 1; i <= 10; ++i) turns.push_back(overTable(0.45, 0.1, 1.5 * i));
  const auto trajectory = motion.trajectory(*start, turns);
  ASSERT_FALSE(trajectory);
  EXPECT_NE(trajectory.reason().find("wrist_3_joint would pass its limit"), std::string::npos)
      << trajectory.reason();
}

// Stretched out, the wrist's centre cannot get farther: the Jacobian loses rank before.
TEST(ArmMotion, refusesToPassASingularity) {
  ArmMotionParameters parameters = tableTop();
  parameters.T_grasp_object = Pose::Identity();
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), parameters);
  // Joint 5 passes 0, where the axes of joints 4 and 6 are parallel.
  JointVector q;
  q << 0.3, -1.2, 1.5, -1.0, 0.5, 0.2;
  JointVector through = q;
  through[4] = -0.5;
  const auto trajectory = motion.trajectory(q, {motion.objectPose(through)});
  ASSERT_FALSE(trajectory);
  EXPECT_NE(trajectory.reason().find("singularity"), std::string::npos) << trajectory.reason();
}

TEST(ArmMotion, refusesToFoldTheArmOntoItself) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  const ArmCollision collision(armUrdf(RobotKind::kUr5e), &motion.model());
  JointVector folded;
  folded << 0.0, -1.57, 3.0, -1.5, -1.57, 0.0;
  EXPECT_TRUE(collision.collidingLinks(folded).has_value());
  JointVector open;
  open << 0.0, -1.2, 1.6, -1.9, -1.57, 0.0;
  EXPECT_FALSE(collision.collidingLinks(open).has_value());
  const auto trajectory = motion.trajectory(open, {motion.objectPose(folded)});
  EXPECT_FALSE(trajectory);
}

TEST(ArmMotion, hasNothingToDoAtTheEndOfThePath) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  const auto q = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(q);
  for (const Path& path : {Path{}, Path{motion.objectPose(*q)}}) {
    const auto trajectory = motion.trajectory(*q, path);
    ASSERT_TRUE(trajectory);
    EXPECT_TRUE(trajectory->points.empty());
  }
}

TEST(ArmMotion, refusesPosesThatAreNotFinite) {
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), tableTop());
  const auto q = motion.configurationFor(overTable(0.45, 0.1));
  ASSERT_TRUE(q);
  Pose bad = overTable(0.45, 0.1);
  bad.translation().x() = std::nan("");
  EXPECT_THROW((void)motion.trajectory(*q, {bad}), InputError);
}

// From the start straight to each place of the workspace, then half a turn either way.
TEST(ArmMotion, reachesTheWholeWorkspaceOfTheShippedScene) {
  const Scenario scenario = loadScenario(SMORE_SOURCE_DIR "/config/scenarios/ur5e_one_peg.yaml");
  const ArmMotion motion(armUrdf(RobotKind::kUr5e), armMotionParameters(scenario));
  const auto start = motion.configurationFor(scenario.start);
  ASSERT_TRUE(start) << start.reason();
  const Vec3 size = scenario.workspace.max - scenario.workspace.min;
  for (const double x : {0.0, 0.5, 1.0}) {
    for (const double y : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      Pose there = scenario.start;
      there.translation() = scenario.workspace.min + size.cwiseProduct(Vec3(x, y, 0.5));
      for (const double turn : {-M_PI_2, M_PI_2}) {
        const Pose quarter = there * Eigen::AngleAxisd(turn, Vec3::UnitZ());
        const Pose half = quarter * Eigen::AngleAxisd(0.99 * turn, Vec3::UnitZ());
        const auto trajectory = motion.trajectory(*start, {there, quarter, half});
        EXPECT_TRUE(trajectory) << trajectory.reason();
      }
    }
  }
}

}  // namespace
}  // namespace smore
