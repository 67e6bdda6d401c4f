// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/ros/press_watch.h"

namespace smore {
namespace {

constexpr auto kFree = ContactState::kFree;
constexpr auto kUnsure = ContactState::kUnsure;
constexpr auto kContact = ContactState::kContact;

// A goal whose end is at 2 s.
void goThroughGoal(bool moved, bool success, PressWatch* watch) {
  watch->observe(1.0, kFree);
  if (moved) watch->setOut();
  watch->observe(2.0, kFree);
  watch->endGoal(success);
}

TEST(PressWatch, knowsWhatPressesUntilItIsSurelyFree) {
  PressWatch watch;
  EXPECT_FALSE(watch.presses());
  watch.observe(1.0, kUnsure);
  EXPECT_FALSE(watch.presses());
  watch.observe(1.1, kContact);
  watch.observe(1.2, kUnsure);
  EXPECT_TRUE(watch.presses());
  watch.observe(1.3, kFree);
  EXPECT_FALSE(watch.presses());
}

TEST(PressWatch, meetsOnTheWayWhatPressesAfterAFailureInMotion) {
  PressWatch watch;
  watch.setOut();
  watch.observe(1.0, kContact);
  EXPECT_FALSE(watch.pressesFromTheWay()) << "the goal goes on";
  watch.endGoal(false);
  watch.observe(60.0, kContact);
  EXPECT_TRUE(watch.pressesFromTheWay());
  watch.endGoal(false);  // of a goal that was refused
  EXPECT_TRUE(watch.pressesFromTheWay());
}

TEST(PressWatch, meetsOnTheWayWhatTheRobotRunsIntoAsItStops) {
  PressWatch watch;
  watch.setOut();
  watch.observe(1.0, kFree);
  watch.endGoal(false);
  watch.observe(1.1, kFree);
  watch.observe(1.2, kContact);
  EXPECT_TRUE(watch.pressesFromTheWay());
}

TEST(PressWatch, doesNotTakeAWeightThatIsGrippedLaterForWhatItMet) {
  for (const bool success : {true, false}) {
    for (const bool moved : {true, false}) {
      PressWatch watch;
      goThroughGoal(moved, success, &watch);
      watch.observe(4.0, kFree);
      watch.observe(5.0, kContact);
      EXPECT_TRUE(watch.presses());
      EXPECT_FALSE(watch.pressesFromTheWay()) << success << moved;
    }
  }
  PressWatch watch;
  goThroughGoal(true, true, &watch);
  watch.observe(2.1, kContact);
  EXPECT_FALSE(watch.pressesFromTheWay()) << "soon after a success";
}

TEST(PressWatch, forgetsWhatItMetOnceTheObjectIsFree) {
  PressWatch watch;
  goThroughGoal(true, false, &watch);
  watch.observe(2.5, kContact);
  watch.observe(3.5, kFree);
  watch.observe(5.0, kContact);
  EXPECT_FALSE(watch.pressesFromTheWay());
}

}  // namespace
}  // namespace smore
