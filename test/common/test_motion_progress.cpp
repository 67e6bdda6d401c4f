// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "smore/common/motion_progress.h"

namespace smore {
namespace {

constexpr double kPeriod = 0.002;  // [s]

Pose at(double x) { return makePose(Vec3(x, 0, 0)); }

/// The first stage that is not "under way" when the robot is at `where(time)`, and its time.
template <typename Where>
std::pair<MotionStage, double> firstStage(double duration, const Pose& target, Where where) {
  MotionProgress progress(0.0, where(0.0), target, duration);
  for (int i = 1;; ++i) {
    const double time = kPeriod * i;
    const MotionStage stage = progress.update(time, where(time));
    if (stage != MotionStage::kUnderWay) return {stage, time};
  }
}

TEST(MotionProgress, arrivesWhenTheRobotStandsAtTheTarget) {
  const auto [stage, time] =
      firstStage(2.0, at(0.1), [](double t) { return at(0.05 * std::min(t, 2.0)); });
  EXPECT_EQ(stage, MotionStage::kArrived);
  EXPECT_NEAR(time, 2.01, 0.005);
}

// It rests at its own end on the way, goes on, and comes back.
TEST(MotionProgress, passesThroughItsOwnEnd) {
  const auto where = [](double t) {
    if (t < 1.1) return at(0.05 * std::min(t, 1.0));
    return at(0.05 + 0.05 * std::max(0.0, std::min(t - 1.1, 2.1 - t)));
  };
  const auto [stage, time] = firstStage(2.0, at(0.05), where);
  EXPECT_EQ(stage, MotionStage::kArrived);
  EXPECT_NEAR(time, 2.11, 0.005);
}

TEST(MotionProgress, stallsWhereTheRobotStands) {
  const auto [stage, time] =
      firstStage(2.0, at(0.1), [](double t) { return at(0.05 * std::min(t, 1.0)); });
  EXPECT_EQ(stage, MotionStage::kStalled);
  EXPECT_NEAR(time, 1.5, 0.01);
}

TEST(MotionProgress, isLateWhenTheRobotCreeps) {
  const auto [stage, time] = firstStage(2.0, at(0.1), [](double t) { return at(0.002 * t); });
  EXPECT_EQ(stage, MotionStage::kLate);
  EXPECT_NEAR(time, 11.0, 0.01);
}

TEST(MotionProgress, addsUpItsLength) {
  MotionProgress progress(0.0, at(0.0), at(0.0), 1.0);
  progress.update(0.5, at(0.1));
  progress.update(1.0, at(0.0));
  EXPECT_DOUBLE_EQ(progress.length(), 0.2);
}

}  // namespace
}  // namespace smore
