// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "smore/kinematics/cartesian_joints.h"

namespace smore {
namespace {

TEST(CartesianJoints, JointsAndPosesAreOne) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  for (int i = 0; i < 200; ++i) {
    const Pose pose = makePose(vector(), M_PI * vector());
    EXPECT_TRUE(fromCartesianJoints(toCartesianJoints(pose)).isApprox(pose, 1e-9));
  }
  for (const double pitch : {M_PI_2, -M_PI_2}) {
    const Pose upright = makePose({1.0, 2.0, 3.0}, {0.4, pitch, -0.9});
    EXPECT_TRUE(fromCartesianJoints(toCartesianJoints(upright)).isApprox(upright, 1e-6));
  }
}

TEST(CartesianJoints, TrajectoriesAreTimedBySpeedAndComeBackInAnyJointOrder) {
  const Path path = {makePose({0, 0, 0}), makePose({0.2, 0, 0}),
                     makePose({0.2, 0, 0}, {0, 0, 1.0})};
  JointTrajectory trajectory = cartesianTrajectory(path, 0.1, 0.5);
  ASSERT_EQ(trajectory.points.size(), 3U);
  EXPECT_DOUBLE_EQ(trajectory.points[0].time, 0.0);
  EXPECT_DOUBLE_EQ(trajectory.points[1].time, 2.0);
  EXPECT_DOUBLE_EQ(trajectory.points[2].time, 4.0);
  std::reverse(trajectory.joint_names.begin(), trajectory.joint_names.end());
  for (auto& point : trajectory.points) {
    std::reverse(point.positions.begin(), point.positions.end());
  }
  const Result<Path> back = cartesianPath(trajectory);
  ASSERT_TRUE(back);
  for (size_t i = 0; i < path.size(); ++i) EXPECT_TRUE((*back)[i].isApprox(path[i], 1e-12));
}

TEST(CartesianJoints, BadTrajectoriesAreRefusedAndEmptyOnesAreEmptyPaths) {
  EXPECT_TRUE(cartesianPath({})->empty());
  const JointTrajectory good = cartesianTrajectory({Pose::Identity()}, 0.1, 0.5);
  JointTrajectory bad = good;
  bad.joint_names[2] = "elbow";
  EXPECT_FALSE(cartesianPath(bad));
  bad = good;
  bad.joint_names[2] = bad.joint_names[0];
  EXPECT_FALSE(cartesianPath(bad));
  bad = good;
  bad.joint_names.emplace_back("gripper");
  EXPECT_FALSE(cartesianPath(bad));
  bad = good;
  bad.points[0].positions.pop_back();
  EXPECT_FALSE(cartesianPath(bad));
  bad = good;
  bad.points[0].positions[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(cartesianPath(bad));
}

}  // namespace
}  // namespace smore
