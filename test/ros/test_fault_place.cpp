// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/ros/fault_place.h"

namespace smore {
namespace {

constexpr bool kFault = true;
constexpr bool kPresses = true;

FaultSign at(double time, double x, bool faulted, bool presses) {
  return {time, makePose(Vec3(x, 0, 0), Vec3::Zero()), faulted, presses};
}

TEST(FaultPlace, isHereUntilTheObjectHasMovedFromWhereTheFaultBegan) {
  FaultPlace place;
  place.observe(at(1.0, 0.0, !kFault, kPresses));
  EXPECT_FALSE(place.isHere());
  place.observe(at(1.1, 0.1, kFault, kPresses));
  place.observe(at(1.2, 0.103, kFault, !kPresses));
  place.observe(at(9.0, 0.103, !kFault, !kPresses));
  EXPECT_TRUE(place.isHere()) << "a bent arm has not been moved";
  place.observe(at(9.1, 0.08, !kFault, kPresses));
  EXPECT_FALSE(place.isHere());
  place.observe(at(9.2, 0.1, !kFault, kPresses));
  EXPECT_FALSE(place.isHere()) << "only a new fault makes it one again";
}

TEST(FaultPlace, isLeftByAMotionDuringTheFault) {
  FaultPlace place;
  place.observe(at(1.0, 0.0, kFault, kPresses));
  place.observe(at(1.1, 0.05, kFault, kPresses));
  place.observe(at(1.2, 0.05, !kFault, kPresses));
  EXPECT_FALSE(place.isHere());
}

TEST(FaultPlace, isWhereTheRobotRunsIntoSomethingAsItStops) {
  FaultPlace place;
  place.observe(at(1.0, 0.0, kFault, !kPresses));
  EXPECT_TRUE(place.isHere()) << "nobody knows yet";
  place.observe(at(1.3, 0.004, kFault, kPresses));
  place.observe(at(9.0, 0.004, !kFault, kPresses));
  EXPECT_TRUE(place.isHere());
}

// The listener is started again, tares under what presses, and the driver's program ends.
TEST(FaultPlace, isHereAfterAFurtherFaultThere) {
  FaultPlace place;
  place.observe(at(1.0, 0.0, kFault, kPresses));
  place.observe(at(2.0, 0.0, !kFault, !kPresses));
  place.observe(at(5.0, 0.0, kFault, !kPresses));
  place.observe(at(9.0, 0.0, !kFault, !kPresses));
  EXPECT_TRUE(place.isHere());
}

// As of a robot that is not started yet; then an object is gripped.
TEST(FaultPlace, isNoneWhereNothingPressedWhenItStoodStill) {
  FaultPlace place;
  place.observe(at(1.0, 0.0, kFault, !kPresses));
  place.observe(at(2.5, 0.0, kFault, !kPresses));
  EXPECT_FALSE(place.isHere());
  place.observe(at(5.0, 0.0, !kFault, kPresses));
  EXPECT_FALSE(place.isHere());
}

constexpr bool kMet = true;

TEST(FaultPlace, knowsThatTheSensorWasZeroedUnderWhatPresses) {
  FaultPlace place;
  place.onProgramStart(kMet);
  place.observe(at(1.0, 0.0, kFault, kPresses));
  EXPECT_FALSE(place.isZeroed());
  place.onProgramStart(!kMet);
  place.observe(at(9.0, 0.0, !kFault, !kPresses));
  EXPECT_TRUE(place.isZeroed()) << "what presses is felt no longer";
  place.observe(at(10.0, 0.0, kFault, !kPresses));
  EXPECT_TRUE(place.isZeroed()) << "nor after a further fault";
  place.observe(at(11.0, 0.02, !kFault, !kPresses));
  EXPECT_FALSE(place.isZeroed()) << "it has been moved";
}

TEST(FaultPlace, knowsSoWhereTheFaultHasNotBeenToldYet) {
  FaultPlace place;
  place.observe(at(1.0, 0.0, !kFault, kPresses));
  place.onProgramStart(kMet);
  place.observe(at(1.1, 0.0, kFault, !kPresses));
  place.observe(at(9.0, 0.0, !kFault, !kPresses));
  EXPECT_TRUE(place.isZeroed());
}

TEST(FaultPlace, isNotZeroedWhereNothingPresses) {
  FaultPlace place;
  place.observe(at(1.0, 0.0, kFault, !kPresses));
  place.onProgramStart(!kMet);
  EXPECT_FALSE(place.isZeroed());
  FaultPlace opened;
  opened.observe(at(1.0, 0.0, kFault, kPresses));
  opened.observe(at(5.0, 0.0, kFault, !kPresses));
  opened.onProgramStart(!kMet);
  EXPECT_FALSE(opened.isZeroed()) << "the gripper was opened by hand";
}

// The program was stopped to grip an object by hand; its weight is zeroed, as it should be.
TEST(FaultPlace, isNoneWhereAnObjectWasGrippedWhileTheProgramDidNotRun) {
  FaultPlace place;
  place.observe(at(1.0, 0.0, !kFault, kPresses));
  place.onProgramStart(!kMet);
  EXPECT_FALSE(place.isHere());
  place.observe(at(1.1, 0.0, !kFault, !kPresses));
  EXPECT_FALSE(place.isHere());
}

}  // namespace
}  // namespace smore
