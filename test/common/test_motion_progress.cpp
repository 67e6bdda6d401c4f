// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "smore/common/motion_progress.h"
#include "smore/common/speed_scaling.h"

namespace smore {
namespace {

constexpr double kPeriod = 0.002;  // [s]

Pose at(double x) { return makePose(Vec3(x, 0, 0)); }

/// The first stage that is not "under way" when the robot is at `where(time)`, and its time.
template <typename Where>
std::pair<MotionStage, double> firstStage(double duration, const Pose& target, Where where,
                                          double scaling = 1.0) {
  MotionProgress progress(0.0, where(0.0), target, duration);
  for (int i = 1;; ++i) {
    const double time = kPeriod * i;
    const MotionStage stage = progress.update(time, where(time), scaling);
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

// A compliant arm that stands a little short of where it was sent.
TEST(MotionProgress, hasEndedWhereTheRobotStandsNearTheTargetToTheLast) {
  for (const double short_of : {0.005, 0.02}) {
    MotionProgress progress(0.0, at(0.0), at(0.1), 2.0);
    MotionStage stage = MotionStage::kUnderWay;
    for (int i = 1; kPeriod * i < 11.1; ++i) {
      stage = progress.update(kPeriod * i, at(std::min(0.05 * kPeriod * i, 0.1 - short_of)), 1.0);
      if (kPeriod * i > 2.5 && kPeriod * i < 10.9) {
        ASSERT_EQ(stage, MotionStage::kStalled);
      }
    }
    EXPECT_EQ(stage, short_of < 0.01 ? MotionStage::kArrived : MotionStage::kLate);
  }
}

// The slider's range: a tenth, as it should be at first, and the least that is no pause.
TEST(MotionProgress, hasLongerWhereTheRobotIsSlower) {
  for (const double scaling : {0.1, kLeastScaling}) {
    const double speed = 0.05 * scaling;
    const auto arriving = [&](double t) { return at(std::min(speed * t, 0.1)); };
    const auto [arrived, arrival] = firstStage(2.0, at(0.1), arriving, scaling);
    EXPECT_EQ(arrived, MotionStage::kArrived);
    EXPECT_NEAR(arrival, 2.01 / scaling, 0.005 / scaling);
    const auto stopping = [&](double t) { return at(std::min(speed * t, 0.05)); };
    const auto [stalled, stop] = firstStage(2.0, at(0.1), stopping, scaling);
    EXPECT_EQ(stalled, MotionStage::kStalled);
    EXPECT_NEAR(stop, 1.5 / scaling, 0.01 / scaling);
  }
}

// Once far from the target, once so near that it counts as there.
TEST(MotionProgress, takesAPauseOfAMinuteForNothing) {
  for (const double moved : {0.05, 0.099}) {
    MotionProgress progress(0.0, at(0.0), at(0.1), 2.0);
    double time = 0.0;
    const auto runs = [&](double duration, double scaling, const auto& where) {
      MotionStage stage = MotionStage::kUnderWay;
      const double begin = time;
      while (stage == MotionStage::kUnderWay && time < begin + duration) {
        time += kPeriod;
        stage = progress.update(time, at(where(time - begin)), scaling);
      }
      return stage;
    };
    const auto before = [&](double t) { return 0.05 * t; };
    ASSERT_EQ(runs(moved / 0.05, 1.0, before), MotionStage::kUnderWay);
    const auto paused = [&](double) { return moved; };
    EXPECT_EQ(runs(60.0, 0.0, paused), MotionStage::kUnderWay);
    const auto after = [&](double t) { return std::min(moved + 0.05 * t, 0.1); };
    EXPECT_EQ(runs(10.0, 1.0, after), MotionStage::kArrived);
    EXPECT_NEAR(time, 62.01, 0.01);
  }
}

TEST(MotionProgress, addsUpItsLength) {
  MotionProgress progress(0.0, at(0.0), at(0.0), 1.0);
  progress.update(0.5, at(0.1), 1.0);
  progress.update(1.0, at(0.0), 1.0);
  EXPECT_DOUBLE_EQ(progress.length(), 0.2);
}

}  // namespace
}  // namespace smore
