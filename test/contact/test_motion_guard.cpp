// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "smore/contact/motion_guard.h"

namespace smore {
namespace {

constexpr double kPeriod = 0.002;  // of both streams [s]
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> kJoints = {"shoulder", "elbow"};

Wrench push(double force) { return {Vec3(0.0, force, 0.0), Vec3::Zero()}; }

// A guard on a clock that only `run` moves.
class MotionGuardTest : public ::testing::Test {
 protected:
  void SetUp() override {
    run(0.01);
    ASSERT_EQ(guard_.fault(), "");
  }

  // Lets time pass with the streams that speak.
  void run(double duration, bool wrenches = true, bool joints = true, bool contacts = true) {
    const int samples = static_cast<int>(std::lround(duration / kPeriod));
    for (int i = 0; i < samples; ++i) {
      now_ += kPeriod;
      if (wrenches) guard_.onWrench(now_, now_, wrench_);
      if (joints) guard_.onJoints(now_, {now_, kJoints, positions_, velocities_});
      if (contacts) guard_.onContact(now_, now_);
      guard_.check(now_);
    }
  }

  // From where the joints are, the first by `step` [rad] within `time` [s].
  JointTrajectory motion(double step, double time) const {
    std::vector<double> end = positions_;
    end[0] += step;
    return {kJoints, {{0.0, positions_, {0.0, 0.0}}, {time, end, {0.0, 0.0}}}};
  }

  void expectRefused(const JointTrajectory& trajectory, const std::string& words) {
    EXPECT_FALSE(guard_.admit(now_, trajectory));
    EXPECT_NE(guard_.fault().find(words), std::string::npos) << guard_.fault();
    guard_.clear(now_);
  }

  MotionGuardParameters parameters_;
  MotionGuard guard_{parameters_, kJoints};
  double now_ = 100.0;
  Wrench wrench_;
  std::vector<double> positions_{0.3, -0.8};
  std::vector<double> velocities_{0.0, 0.0};
};

TEST_F(MotionGuardTest, LetsAProperMotionPass) {
  EXPECT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  EXPECT_EQ(guard_.fault(), "");
}

TEST_F(MotionGuardTest, OneSampleAboveTheForceCeilingLatches) {
  wrench_ = push(39.9);
  run(0.1);
  EXPECT_EQ(guard_.fault(), "");
  wrench_ = push(40.1);
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "the force is 40.1 N, above the limit of 40 N");
  wrench_ = push(0.0);
  run(1.0);
  EXPECT_NE(guard_.fault(), "");
  EXPECT_FALSE(guard_.admit(now_, motion(0.1, 1.0)));
}

TEST_F(MotionGuardTest, TheTorqueHasACeilingOfItsOwn) {
  wrench_.torque = Vec3(0.0, 6.0, -6.0);
  run(kPeriod);
  EXPECT_NE(guard_.fault().find("the torque is 8.49 N m"), std::string::npos) << guard_.fault();
}

TEST_F(MotionGuardTest, AfterAClearingTheForceMayOnlyFall) {
  wrench_ = push(60.0);
  run(kPeriod);
  guard_.clear(now_);
  run(0.1);
  EXPECT_EQ(guard_.fault(), "") << "as high as at the clearing";
  EXPECT_TRUE(guard_.admit(now_, motion(0.1, 1.0))) << "the retreat";
  wrench_ = push(45.0);
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "") << "it falls";
  wrench_ = push(56.0);
  run(kPeriod);
  EXPECT_NE(guard_.fault(), "") << "45 N were reached, so 55 N are the ceiling";
}

TEST_F(MotionGuardTest, OnceTheForceHasFallenTheCeilingIsBack) {
  wrench_ = push(60.0);
  run(kPeriod);
  guard_.clear(now_);
  wrench_ = push(5.0);
  run(kPeriod);
  wrench_ = push(41.0);
  run(kPeriod);
  EXPECT_NE(guard_.fault(), "");
}

TEST_F(MotionGuardTest, SilenceOfEitherStreamLatchesAfterItsTime) {
  run(0.05, false, true);
  EXPECT_EQ(guard_.fault(), "");
  run(2 * kPeriod, false, true);
  EXPECT_EQ(guard_.fault(), "no new wrench for over 50 ms; are driver and network up?");
  guard_.clear(now_);
  EXPECT_NE(guard_.fault(), "") << "still silent";
  run(kPeriod);
  guard_.clear(now_);
  EXPECT_EQ(guard_.fault(), "");
  run(0.05 + 2 * kPeriod, true, false);
  EXPECT_EQ(guard_.fault(), "no new joint states for over 50 ms; are driver and network up?");
}

TEST_F(MotionGuardTest, ARepeatedMessageIsSilence) {
  for (int i = 0; i < 30; ++i) {
    now_ += kPeriod;
    guard_.onWrench(now_, 1.0, wrench_);
    guard_.onJoints(now_, {now_, kJoints, positions_, velocities_});
    guard_.check(now_);
  }
  EXPECT_NE(guard_.fault().find("no new wrench"), std::string::npos) << guard_.fault();
}

TEST(MotionGuard, NothingMovesBeforeAllStreamsHaveSpoken) {
  const JointTrajectory motion{{"joint"}, {{1.0, {0.0}, {}}}};
  MotionGuard deaf({}, {"joint"});
  deaf.check(1e6);
  EXPECT_EQ(deaf.fault(), "") << "not silent before it has begun";
  EXPECT_FALSE(deaf.admit(0.0, motion));
  MotionGuard blind({}, {"joint"});
  blind.onWrench(0.0, 0.0, {});
  EXPECT_FALSE(blind.admit(0.0, motion));
  MotionGuard numb({}, {"joint"});
  numb.onWrench(0.0, 0.0, {});
  numb.onJoints(0.0, {0.0, {"joint"}, {0.0}, {0.0}});
  EXPECT_FALSE(numb.admit(0.0, motion));
  EXPECT_NE(numb.fault().find("before any contact observation"), std::string::npos);
}

TEST_F(MotionGuardTest, ValuesThatAreNotFiniteLatch) {
  wrench_.torque.x() = kNan;
  run(kPeriod);
  EXPECT_NE(guard_.fault(), "");
  guard_.clear(now_);
  EXPECT_EQ(guard_.fault(), "");
  run(kPeriod);
  EXPECT_NE(guard_.fault(), "") << "wrong still";
  wrench_ = {};
  guard_.clear(now_);
  positions_[1] = kNan;
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "a joint state has a value that is not finite");
}

TEST_F(MotionGuardTest, AJointAboveItsSpeedLatches) {
  velocities_[1] = -2.01;
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "the speed of elbow is 2.01 rad/s, above the limit of 2 rad/s");
}

TEST_F(MotionGuardTest, AnotherDevicesJointsSayNothing) {
  guard_.onJoints(now_, {now_, {"finger"}, {kNan}, {}});
  EXPECT_EQ(guard_.fault(), "");
  guard_.onJoints(now_, {now_, {"finger", "elbow", "shoulder"}, {0.0, -0.8, 0.3}, {9.0, 0.0, 0.0}});
  EXPECT_EQ(guard_.fault(), "");
}

TEST_F(MotionGuardTest, RefusesAStartThatIsNotWhereTheJointsAre) {
  JointTrajectory trajectory = motion(0.2, 1.0);
  trajectory.points[0].positions[1] += 0.11;
  expectRefused(trajectory, "elbow from the commanded start");
}

TEST_F(MotionGuardTest, ALaterFirstPointIsReachedFromWhereTheJointsAre) {
  JointTrajectory trajectory{kJoints, {{1.0, {0.3 + 1.9, -0.8}, {}}}};
  EXPECT_TRUE(guard_.admit(now_, trajectory));
  trajectory.points[0].time = 0.9;
  expectRefused(trajectory, "the commanded speed of shoulder");
}

// From rest to rest a cubic is 1.5 times as fast in its middle as on average.
TEST_F(MotionGuardTest, TheCommandedSpeedIsThatBetweenThePoints) {
  EXPECT_TRUE(guard_.admit(now_, motion(1.33, 1.0)));
  expectRefused(motion(-1.34, 1.0), "the commanded speed of shoulder is 2.01 rad/s");
  JointTrajectory straight = motion(1.99, 1.0);
  for (JointTrajectoryPoint& point : straight.points) point.velocities.clear();
  EXPECT_TRUE(guard_.admit(now_, straight));
}

TEST_F(MotionGuardTest, RefusesWhatIsNoTrajectoryOfTheRobot) {
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

TEST_F(MotionGuardTest, JointsOfACommandComeInAnyOrder) {
  const JointTrajectory swapped{{"elbow", "shoulder"},
                                {{0.0, {-0.8, 0.3}, {}}, {1.0, {-0.8, 0.5}, {}}}};
  EXPECT_TRUE(guard_.admit(now_, swapped));
}

TEST_F(MotionGuardTest, AMotionBeginsAtTimeZeroWithItsJointsInOrder) {
  const auto motion = guard_.admit(now_, {{"elbow", "shoulder"}, {{1.0, {-0.7, 0.5}, {0.0, 0.0}}}});
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->joint_names, kJoints);
  ASSERT_EQ(motion->points.size(), 2U);
  EXPECT_EQ(motion->points[0].time, 0.0);
  EXPECT_EQ(motion->points[0].positions, positions_);
  EXPECT_EQ(motion->points[0].velocities, std::vector<double>({0.0, 0.0}));
  EXPECT_EQ(motion->points[1].positions, std::vector<double>({0.5, -0.7}));
}

TEST_F(MotionGuardTest, RefusesAMotionThatDoesNotEndAtRest) {
  JointTrajectory trajectory = motion(0.1, 1.0);
  trajectory.points[1].velocities[1] = 0.1;
  expectRefused(trajectory, "does not end at rest");
}

TEST_F(MotionGuardTest, AMotionThatNobodyAttendsToLatches) {
  ASSERT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  const JointTrajectoryPoint here{0.0, positions_, velocities_};
  run(0.09);
  guard_.checkMotion(now_, here);
  EXPECT_EQ(guard_.fault(), "");
  guard_.onSignOfLife(now_);
  run(0.09);
  guard_.checkMotion(now_, here);
  EXPECT_EQ(guard_.fault(), "");
  run(0.02);
  guard_.checkMotion(now_, here);
  EXPECT_NE(guard_.fault().find("no sign of life"), std::string::npos) << guard_.fault();
}

TEST_F(MotionGuardTest, AMotionWithoutContactObservationsLatches) {
  const JointTrajectoryPoint here{0.0, positions_, velocities_};
  ASSERT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  run(0.04, true, true, false);
  guard_.checkMotion(now_, here);
  EXPECT_EQ(guard_.fault(), "");
  run(0.02, true, true, false);
  EXPECT_EQ(guard_.fault(), "") << "a robot at rest needs none";
  guard_.checkMotion(now_, here);
  EXPECT_NE(guard_.fault().find("contact observations are late"), std::string::npos);
}

// Observations that come as often as they should and speak of long ago are no reflex.
TEST_F(MotionGuardTest, AMotionWithContactObservationsOfLongAgoLatches) {
  ASSERT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  for (int i = 0; i < 5; ++i) {
    run(kPeriod, true, true, false);
    guard_.onContact(now_, now_ - 0.06);
    guard_.checkMotion(now_, {0.0, positions_, velocities_});
  }
  EXPECT_NE(guard_.fault().find("contact observations are late"), std::string::npos);
}

TEST_F(MotionGuardTest, ARobotThatDoesNotFollowLatches) {
  ASSERT_TRUE(guard_.admit(now_, motion(0.5, 1.0)));
  guard_.checkMotion(now_, {0.0, {0.39, -0.8}, velocities_});
  EXPECT_EQ(guard_.fault(), "");
  guard_.checkMotion(now_, {0.0, {0.41, -0.8}, velocities_});
  EXPECT_NE(guard_.fault().find("shoulder from its motion"), std::string::npos) << guard_.fault();
}

TEST_F(MotionGuardTest, KnowsTheJointsWhileTheyAreNew) {
  velocities_ = {0.1, -0.2};
  run(kPeriod);
  const auto joints = guard_.joints(now_);
  ASSERT_TRUE(joints);
  EXPECT_EQ(joints->time, now_);
  EXPECT_EQ(joints->velocities, velocities_);
  EXPECT_FALSE(guard_.joints(now_ + 0.051));
}

TEST_F(MotionGuardTest, TheFirstFaultIsKept) {
  guard_.stop("stopped by the user");
  wrench_ = push(100.0);
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "stopped by the user");
}

}  // namespace
}  // namespace smore
