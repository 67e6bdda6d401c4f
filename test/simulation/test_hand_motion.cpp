// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/simulation/hand_motion.h"

namespace smore {
namespace {

constexpr double kStep = 0.001;

int stepsToEnd(HandMotion* hand) {
  int steps = 0;
  while (hand->moving()) {
    hand->advance(kStep);
    ++steps;
  }
  return steps;
}

TEST(HandMotion, takesTheTimeOfTheSlowerLimit) {
  HandMotion hand(Pose::Identity(), 0.1, 0.5);
  hand.follow({makePose(Vec3(0.1, 0, 0))});
  EXPECT_NEAR(stepsToEnd(&hand), 1000, 1);
  hand.follow({makePose(Vec3(0.1, 0, 0), Vec3(0, 0, 1.0))});
  EXPECT_NEAR(stepsToEnd(&hand), 2000, 1);
  hand.follow({makePose(Vec3(0.3, 0, 0), Vec3(0, 0, 1.5))});
  EXPECT_NEAR(stepsToEnd(&hand), 2000, 1);
}

TEST(HandMotion, keepsItsSpeedOverCornersAndRepeatedPoses) {
  HandMotion hand(Pose::Identity(), 0.1, 0.5);
  const Pose corner = makePose(Vec3(0.05, 0, 0));
  const Pose end = makePose(Vec3(0.05, 0.05, 0));
  hand.follow({Pose::Identity(), corner, corner, end, end});
  Vec3 before = Vec3::Zero();
  double length = 0.0;
  while (hand.moving()) {
    hand.advance(kStep);
    const double moved = (hand.pose().translation() - before).norm();
    EXPECT_LE(moved, 0.1 * kStep + 1e-12);
    length += moved;
    before = hand.pose().translation();
  }
  EXPECT_NEAR(length, 0.1, 1e-4);
  EXPECT_EQ(hand.pose().matrix(), end.matrix());
}

TEST(HandMotion, stopsAtOnceAndStartsFromThere) {
  HandMotion hand(Pose::Identity(), 0.1, 0.5);
  hand.follow({makePose(Vec3(1, 0, 0))});
  for (int i = 0; i < 500; ++i) hand.advance(kStep);
  hand.stop();
  EXPECT_FALSE(hand.moving());
  hand.advance(kStep);
  EXPECT_NEAR(hand.pose().translation().x(), 0.05, 1e-12);
  hand.follow({Pose::Identity()});
  EXPECT_NEAR(stepsToEnd(&hand), 500, 1);
}

TEST(HandMotion, anEmptyPathOrPlacingEndsTheMotion) {
  HandMotion hand(Pose::Identity(), 0.1, 0.5);
  hand.follow({});
  EXPECT_FALSE(hand.moving());
  hand.follow({makePose(Vec3(1, 0, 0))});
  hand.place(makePose(Vec3(0, 2, 0)));
  EXPECT_FALSE(hand.moving());
  EXPECT_DOUBLE_EQ(hand.pose().translation().y(), 2.0);
}

}  // namespace
}  // namespace smore
