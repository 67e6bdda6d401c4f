// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/contact/hold_up_watch.h"

namespace smore {
namespace {

constexpr double kLongest = 0.02;  // [s]

TEST(HoldUpWatch, HearsUpToEachShortTurn) {
  HoldUpWatch watch(100.0, kLongest);
  for (int i = 1; i <= 10; ++i) {
    const double now = 100.0 + 0.019 * i;
    watch.onTurn(now);
    EXPECT_EQ(watch.heard(), now);
    EXPECT_TRUE(watch.upToDate(now));
  }
}

TEST(HoldUpWatch, AfterAHoldUpItKnowsNoMoreUntilItHasListened) {
  HoldUpWatch watch(100.0, kLongest);
  watch.onTurn(100.001);
  EXPECT_FALSE(watch.upToDate(100.5)) << "as soon as it wakes";
  for (const double listening : {100.5, 100.501, 100.519}) {
    watch.onTurn(listening);
    EXPECT_EQ(watch.heard(), 100.001);
    EXPECT_FALSE(watch.upToDate(listening));
  }
  watch.onTurn(100.521);
  EXPECT_EQ(watch.heard(), 100.521);
  EXPECT_TRUE(watch.upToDate(100.521));
}

// So that silence is told however slow the machine is.
TEST(HoldUpWatch, OfTurnsThatAreAllLongEverySecondOneHears) {
  for (const double turn : {0.021, 0.05, 1.0}) {
    HoldUpWatch watch(0.0, kLongest);
    for (int i = 1; i <= 20; ++i) {
      watch.onTurn(turn * i);
      EXPECT_EQ(watch.heard(), turn * (i - i % 2)) << i;
    }
  }
}

TEST(HoldUpWatch, HeldUpWhileItListensItWaitsNoLonger) {
  HoldUpWatch watch(0.0, kLongest);
  watch.onTurn(1.0);
  watch.onTurn(1.5);
  EXPECT_EQ(watch.heard(), 1.5);
}

}  // namespace
}  // namespace smore
