// SPDX-License-Identifier: BSD-3-Clause
#include "guarded_robot.h"

namespace smore {
namespace {

class GuardedMotionTest : public MotionGuardTest {};

TEST_F(GuardedMotionTest, RefusesAStartThatIsNotWhereTheJointsAre) {
  JointTrajectory trajectory = motion(0.2, 1.0);
  trajectory.points[0].positions[1] += 0.031;
  expectRefused(trajectory, "elbow from the commanded start");
}

TEST_F(GuardedMotionTest, ALaterFirstPointIsReachedFromWhereTheJointsAre) {
  JointTrajectory trajectory{kJoints, {{1.0, {0.3 + 1.9, -0.8}, {}}}};
  EXPECT_TRUE(guard_.admit(now_, trajectory));
  trajectory.points[0].time = 0.9;
  expectRefused(trajectory, "the commanded speed of shoulder");
}

// It begins at rest, so that it is faster in its middle than on average.
TEST_F(GuardedMotionTest, TheWayToALaterFirstPointIsAsFastAsItIsExecuted) {
  const auto first_at = [](double time) {
    return JointTrajectory{kJoints, {{time, {0.3 + 1.9, -0.8}, {0.0, 0.0}}}};
  };
  EXPECT_TRUE(guard_.admit(now_, first_at(1.45)));
  expectRefused(first_at(1.0), "the commanded speed of shoulder is 2.85 rad/s");
}

// From rest to rest a cubic is 1.5 times as fast in its middle as on average.
TEST_F(GuardedMotionTest, TheCommandedSpeedIsThatBetweenThePoints) {
  EXPECT_TRUE(guard_.admit(now_, motion(1.33, 1.0)));
  expectRefused(motion(-1.34, 1.0), "the commanded speed of shoulder is 2.01 rad/s");
  JointTrajectory straight = motion(1.99, 1.0);
  for (JointTrajectoryPoint& point : straight.points) point.velocities.clear();
  EXPECT_TRUE(guard_.admit(now_, straight));
}

TEST_F(GuardedMotionTest, RefusesWhatIsNoTrajectoryOfTheRobot) {
  JointTrajectory trajectory = motion(0.1, 1.0);
  trajectory.points[1].time = 0.0;
  expectRefused(trajectory, "times do not rise");
  trajectory = motion(0.1, kNan);
  expectRefused(trajectory, "not finite");
  trajectory = motion(0.1, 1.0);
  trajectory.joint_names[0] = "wrist";
  expectRefused(trajectory, "not one of all of the robot's joints");
  trajectory = motion(0.1, 1.0);
  trajectory.points[1].velocities = {0.0};
  expectRefused(trajectory, "not one of all of the robot's joints");
}

TEST_F(GuardedMotionTest, JointsOfACommandComeInAnyOrder) {
  const JointTrajectory swapped{{"elbow", "shoulder"},
                                {{0.0, {-0.8, 0.3}, {}}, {1.0, {-0.8, 0.5}, {}}}};
  EXPECT_TRUE(guard_.admit(now_, swapped));
}

TEST_F(GuardedMotionTest, AMotionBeginsAtTimeZeroWithItsJointsInOrder) {
  const auto motion = guard_.admit(now_, {{"elbow", "shoulder"}, {{1.0, {-0.7, 0.5}, {0.0, 0.0}}}});
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->joint_names, kJoints);
  ASSERT_EQ(motion->points.size(), 2U);
  EXPECT_EQ(motion->points[0].time, 0.0);
  EXPECT_EQ(motion->points[0].positions, positions_);
  EXPECT_EQ(motion->points[0].velocities, std::vector<double>({0.0, 0.0}));
  EXPECT_EQ(motion->points[1].positions, std::vector<double>({0.5, -0.7}));
}

TEST_F(GuardedMotionTest, RefusesAMotionThatDoesNotEndAtRest) {
  JointTrajectory trajectory = motion(0.1, 1.0);
  trajectory.points[1].velocities[1] = 0.1;
  expectRefused(trajectory, "does not end at rest");
}

// As on a computer that is busy for a moment.
TEST_F(GuardedMotionTest, AMotionWaitsWhileAStreamIsLateAndMayGoOn) {
  ASSERT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  EXPECT_EQ(guard_.lateness(now_), "");
  const auto waits_without = [&](bool wrenches, bool joints, bool contacts) {
    run(0.048, wrenches, joints, contacts);
    guard_.onSignOfLife(now_);
    const bool early = !guard_.lateness(now_).empty();
    run(0.1, wrenches, joints, contacts);
    guard_.onSignOfLife(now_);
    const bool waits = !guard_.lateness(now_).empty();
    run(kPeriod);
    return waits && !early && guard_.lateness(now_).empty();
  };
  EXPECT_TRUE(waits_without(false, true, true));
  EXPECT_TRUE(waits_without(true, false, true));
  EXPECT_TRUE(waits_without(true, true, false));
  guard_.checkMotion(now_, {0.0, positions_, velocities_});
  EXPECT_EQ(guard_.fault(), "");
}

TEST_F(GuardedMotionTest, AMotionThatNobodyAttendsToWaitsAndThenLatches) {
  ASSERT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  const JointTrajectoryPoint here{0.0, positions_, velocities_};
  const auto check_after = [&](double duration) {
    run(duration);
    guard_.checkMotion(now_, here);
  };
  check_after(0.048);
  EXPECT_EQ(guard_.lateness(now_), "");
  check_after(0.004);
  EXPECT_NE(guard_.lateness(now_).find("no sign of life"), std::string::npos);
  guard_.onSignOfLife(now_);
  EXPECT_EQ(guard_.lateness(now_), "");
  check_after(0.19);
  EXPECT_EQ(guard_.fault(), "");
  check_after(0.02);
  EXPECT_NE(guard_.fault().find("no sign of life"), std::string::npos) << guard_.fault();
}

TEST_F(GuardedMotionTest, ARobotThatDoesNotFollowLatches) {
  ASSERT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  guard_.checkMotion(now_, {0.0, {0.32, -0.8}, velocities_});
  EXPECT_EQ(guard_.fault(), "");
  guard_.checkMotion(now_, {0.0, {0.34, -0.8}, velocities_});
  EXPECT_NE(guard_.fault().find("shoulder from its motion"), std::string::npos) << guard_.fault();
}

// It gets each command later than it was sent.
TEST_F(GuardedMotionTest, AJointThatMovesMayBeLate) {
  ASSERT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  guard_.checkMotion(now_, {0.0, {0.42, -0.8}, {1.0, 0.0}});
  EXPECT_EQ(guard_.fault(), "");
  guard_.checkMotion(now_, {0.0, {0.42, -0.8}, {-0.8, 0.0}});
  EXPECT_NE(guard_.fault(), "");
}

}  // namespace
}  // namespace smore
