// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "smore/common/trail.h"

namespace smore {
namespace {

Pose at(double x) { return makePose(Vec3(x, 0, 0)); }

constexpr double kAll = std::numeric_limits<double>::infinity();

/// A way of 10 cm along x.
Trail recordedTrail() {
  Trail trail;
  for (int i = 0; i <= 100; ++i) trail.record(at(0.001 * i));
  return trail;
}

TEST(Trail, LeadsBackAsFarAsAsked) {
  const Path back = recordedTrail().wayBack(at(0.1), 0.05);
  ASSERT_FALSE(back.empty());
  EXPECT_NEAR(back.back().translation().x(), 0.05, 0.002);
  for (size_t i = 1; i < back.size(); ++i) {
    EXPECT_LT(back[i].translation().x(), back[i - 1].translation().x());
  }
}

TEST(Trail, KeepsWhatTheRobotHasNotGoneBackAlong) {
  Trail trail = recordedTrail();
  for (int i = 0; i <= 100; ++i) trail.unwind(at(0.1 - 0.0005 * i));
  const Path rest = trail.wayBack(at(0.05), kAll);
  EXPECT_NEAR(rest.front().translation().x(), 0.05, 0.002);
  EXPECT_TRUE(rest.back().isApprox(at(0)));
}

TEST(Trail, KnowsWhetherTheRobotWasMovedAway) {
  EXPECT_TRUE(recordedTrail().endsAt(at(0.105)));
  EXPECT_FALSE(recordedTrail().endsAt(at(0.115)));
  EXPECT_FALSE(Trail().endsAt(at(0.0)));
}

// No way back leads over a jump: by hand, say, away from where the guard had stopped it.
TEST(Trail, BeginsAnewWhereTheRobotWasMovedAway) {
  Trail trail = recordedTrail();
  trail.setOutFrom(at(0.105));
  EXPECT_TRUE(trail.wayBack(at(0.105), kAll).back().isApprox(at(0)));
  trail.setOutFrom(at(0.13));
  for (int i = 0; i < 20; ++i) trail.record(at(0.13 + 0.001 * i));
  EXPECT_TRUE(trail.wayBack(at(0.15), kAll).back().isApprox(at(0.13)));
}

TEST(Trail, FollowsItsOwnWayBackWhereItCrossesItself) {
  Trail trail;
  const Path loop{at(0.0), at(0.01), makePose(Vec3(0.01, 0.01, 0)), makePose(Vec3(0, 0.01, 0)),
                  at(0.001)};
  for (const Pose& pose : loop) trail.record(pose);
  trail.unwind(at(0.0));
  EXPECT_EQ(trail.wayBack(at(0.0), kAll).size(), loop.size());
}

TEST(Trail, EndsAtTheBeginning) {
  Trail trail = recordedTrail();
  for (int i = 100; i >= 0; --i) trail.unwind(at(0.001 * i));
  EXPECT_TRUE(trail.wayBack(at(0), kAll).empty());
  EXPECT_FALSE(trail.wayBack(at(0.01), kAll).empty());
}

TEST(Trail, KeepsPosesThatDifferOnly) {
  Trail trail;
  for (int i = 0; i < 1000; ++i) trail.record(at(0));
  EXPECT_EQ(trail.wayBack(at(0.1), 1.0).size(), 1u);
}

}  // namespace
}  // namespace smore
