// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "smore/planning/posture_paths.h"

namespace smore {
namespace {

constexpr double kLever = 0.3;

RiskSpace spaceOf(Motion motion) {
  const double z = motion == Motion::kPlanar ? 0.01 : 0.4;
  const MotionSpace space{
      motion, Pose::Identity(), {Vec3(-1.3, -0.7, -z), Vec3(0.4, 0.7, z)}, true};
  return {space, Pose::Identity(), kLever};
}

class PosturePathsIn : public testing::TestWithParam<Motion> {
 protected:
  const RiskSpace space_ = spaceOf(GetParam());
  const SampledWorlds nothing_known_{};
  const RiskMotions motions_{nothing_known_, kLever};
  const RiskState start_ = space_.toState(makePose({0, 0, 0}));
  const RiskState goal_ = space_.toState(makePose({-1, 0.1, 0}));

  std::vector<RiskPath> best(int tried, int kept, std::uint64_t seed, double seconds = 60.0) const {
    return PosturePaths(motions_, space_, {{}, nullptr, 0.0})
        .best(start_, goal_, tried, kept, Deadline(seconds), seed);
  }
};

TEST_P(PosturePathsIn, KeepsTheBestOfAllThatAreTried) {
  const auto all = best(60, 60, 3);
  const auto few = best(60, 5, 3);
  ASSERT_GE(all.size(), 30U);
  ASSERT_EQ(few.size(), 5U);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].value(), all[i].value());
  }
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), isBetter));
}

TEST_P(PosturePathsIn, GoesOnInOnePostureInsideOfTheWorkspace) {
  for (const RiskPath& path : best(60, 60, 4)) {
    const auto& states = path.states();
    ASSERT_EQ(states.size(), 4U);
    EXPECT_EQ(states.front().position, start_.position);
    EXPECT_EQ(states.back().position, goal_.position);
    EXPECT_TRUE(states[1].rotation.isApprox(states[2].rotation));
    for (const RiskState& state : states) EXPECT_TRUE(space_.contains(state));
  }
}

TEST_P(PosturePathsIn, TriesNoMoreOnceTheDeadlineHasPassed) {
  EXPECT_TRUE(best(60, 60, 3, 0.0).empty());
}

// The coarsest postures of all, quarter turns, are among few tries already.
TEST_P(PosturePathsIn, TriesQuarterTurns) {
  int quarters = 0;
  for (const RiskPath& path : best(100, 100, 5)) {
    const Eigen::Matrix3f turn = path.states()[1].rotation.toRotationMatrix();
    quarters += ((turn.array().abs() - turn.array().square()).abs() < 1e-4F).all() ? 1 : 0;
  }
  EXPECT_GT(quarters, 30);
}

INSTANTIATE_TEST_SUITE_P(Motions, PosturePathsIn,
                         testing::Values(Motion::kPlanar, Motion::kSpatial));

}  // namespace
}  // namespace smore
