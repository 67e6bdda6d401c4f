// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/common/retreat.h"

namespace smore {
namespace {

/// A way of so many stretches, on which something touches for so many of them.
struct Way {
  int left = 0;
  int touching = 0;
  MotionEnd end = MotionEnd::kReached;
  int gone = 0;

  std::optional<MotionResult> retreat() {
    return retreatInStretches({[this] { return left > gone ? Path{Pose::Identity()} : Path{}; },
                               [this](const Path&) {
                                 ++gone;
                                 MotionResult result;
                                 result.end = end;
                                 return result;
                               },
                               [this] { return gone >= touching; }});
  }
};

TEST(Retreat, GoesOnUntilNothingTouches) {
  Way way{5, 3};
  const auto result = way.retreat();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->end, MotionEnd::kReached);
  EXPECT_EQ(way.gone, 3);
}

TEST(Retreat, OfARobotThatIsBackMovesNothing) {
  Way way{0, 0};
  EXPECT_TRUE(way.retreat());
  EXPECT_EQ(way.gone, 0);
}

TEST(Retreat, GivesUpAtTheBeginningOfTheWay) {
  Way way{2, 3};
  EXPECT_FALSE(way.retreat());
  EXPECT_EQ(way.gone, 2);
}

TEST(Retreat, GivesUpOnAWayThatDoesNotEnd) {
  Way way{1000, 1000};
  EXPECT_FALSE(way.retreat());
  EXPECT_LT(way.gone, 100);
}

TEST(Retreat, EndsWithAMotionThatFails) {
  Way way{5, 3, MotionEnd::kFault};
  const auto result = way.retreat();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->end, MotionEnd::kFault);
  EXPECT_EQ(way.gone, 1);
}

}  // namespace
}  // namespace smore
