// SPDX-License-Identifier: BSD-3-Clause
#include "guarded_robot.h"

namespace smore {
namespace {

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

TEST_F(MotionGuardTest, ALoweredCeilingHoldsFromTheNextSampleOn) {
  wrench_ = push(15.0);
  run(kPeriod);
  guard_.limitTo({20.0, 8.0, 2.0});
  wrench_ = push(19.9);
  run(0.1);
  EXPECT_EQ(guard_.fault(), "");
  wrench_ = push(20.1);
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "the force is 20.1 N, above the limit of 20 N");
}

TEST_F(MotionGuardTest, ACeilingThatIsLoweredInARetreatLetsItGoOn) {
  wrench_ = push(60.0);
  run(kPeriod);
  guard_.clear(now_);
  guard_.limitTo({20.0, 8.0, 2.0});
  run(0.1);
  EXPECT_EQ(guard_.fault(), "") << "as high as at the clearing";
  wrench_ = push(5.0);
  run(kPeriod);
  wrench_ = push(21.0);
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "the force is 21 N, above the limit of 20 N");
}

TEST_F(MotionGuardTest, ALoweredSpeedHoldsForJointsAndCommands) {
  guard_.limitTo({40.0, 8.0, 0.5});
  expectRefused(motion(0.5, 1.0), "the commanded speed of shoulder");
  velocities_ = {0.6, 0.0};
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "the speed of shoulder is 0.6 rad/s, above the limit of 0.5 rad/s");
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
  EXPECT_NE(numb.fault().find("before the listener had tared"), std::string::npos);
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

TEST_F(MotionGuardTest, KnowsTheJointsWhileTheyAreNew) {
  velocities_ = {0.1, -0.2};
  run(kPeriod);
  const auto joints = guard_.joints(now_);
  ASSERT_TRUE(joints);
  EXPECT_EQ(joints->time, now_);
  EXPECT_EQ(joints->velocities, velocities_);
  EXPECT_FALSE(guard_.joints(now_ + 0.051));
}

// However late a motion may be told on a bad network.
TEST(MotionGuard, DoesNotBrakeFromWhereTheJointsWereLongAgo) {
  MotionGuardParameters patient;
  patient.max_lateness = 0.5;
  patient.max_silence = 0.5;
  MotionGuard guard(patient, {"joint"});
  EXPECT_FALSE(guard.jointsToBrakeFrom(0.0));
  guard.onJoints(1.0, {1.0, {"joint"}, {0.2}, {0.1}});
  EXPECT_TRUE(guard.jointsToBrakeFrom(1.04));
  EXPECT_FALSE(guard.jointsToBrakeFrom(1.06));
  EXPECT_TRUE(guard.joints(1.4));
}

TEST_F(MotionGuardTest, ARobotWhoseProgramHasEndedMovesOnlyAfterItRunsAndAClearing) {
  guard_.onProgram(false);
  run(kPeriod);
  EXPECT_NE(guard_.fault().find("program does not run"), std::string::npos) << guard_.fault();
  guard_.clear(now_);
  EXPECT_NE(guard_.fault(), "");
  guard_.onProgram(true);
  run(kPeriod);
  EXPECT_FALSE(guard_.admit(now_, motion(0.1, 1.0)));
  guard_.clear(now_);
  EXPECT_TRUE(guard_.admit(now_, motion(0.1, 1.0)));
}

// The two come on topics of their own, in any order.
TEST_F(MotionGuardTest, TheSafetyModeTellsWhyTheProgramEnded) {
  guard_.onProgram(false);
  run(kPeriod);
  guard_.onSafetyStop("a protective stop");
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "a protective stop");
}

TEST_F(MotionGuardTest, TheFirstFaultIsKept) {
  guard_.stop("stopped by the user");
  wrench_ = push(100.0);
  run(kPeriod);
  EXPECT_EQ(guard_.fault(), "stopped by the user");
}

}  // namespace
}  // namespace smore
