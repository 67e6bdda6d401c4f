// SPDX-License-Identifier: BSD-3-Clause
// The mean of a wrench against swings of any frequency and phase, and against noise alone.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "smore/contact/steady_mean.h"

namespace smore {
namespace {

constexpr double kWindow = 0.02;     // [s]
constexpr double kPeriod = 0.002;    // [s]
const Vec3 kForce(6.0, -2.0, 1.0);   // [N]
const Vec3 kTorque(0.1, 0.4, -0.2);  // [N m]

// A wrench that swings about the one above with a damping ratio of 0.1.
Wrench swinging(double time, double frequency, double phase) {
  const double swing = std::exp(-0.1 * frequency * time) * std::cos(frequency * time + phase);
  return {kForce + swing * Vec3(1.0, 3.0, 0.0), kTorque + swing * Vec3(0.5, 0.0, 1.0)};
}

// When the mean is first full and steady; the mean in `mean`.
std::optional<double> firstSteady(double frequency, double phase, Wrench* mean) {
  SteadyMean average({kWindow}, {});
  for (int i = 0; i < 5000; ++i) {
    average.add(i * kPeriod, swinging(i * kPeriod, frequency, phase));
    if (!average.full() || !average.steady()) continue;
    *mean = average.mean();
    return i * kPeriod;
  }
  return std::nullopt;
}

TEST(SteadyMean, isGivenAtOnceWhereNothingSwings) {
  SteadyMean average({kWindow}, {});
  for (int i = 0; i <= 10; ++i) {
    EXPECT_FALSE(average.full());
    average.add(i * kPeriod, {kForce, kTorque});
  }
  EXPECT_TRUE(average.full());
  EXPECT_TRUE(average.steady());
  EXPECT_LT((average.mean().force - kForce).norm(), 1e-12);
  EXPECT_EQ(average.swing().force, 0.0);
}

// Of swings of 3.2 N at the beginning, at all phases: the window never takes a turning point for
// rest.
TEST(SteadyMean, isFarNearerThanTheSwingThatItWaitsFor) {
  for (const double frequency : {60.0, 80.0, 120.0, 200.0, 300.0}) {  // [rad/s]
    for (double phase = 0.0; phase < 2.0 * M_PI; phase += 0.1) {
      Wrench mean;
      const auto time = firstSteady(frequency, phase, &mean);
      ASSERT_TRUE(time) << frequency << " rad/s, " << phase;
      EXPECT_LT((mean.force - kForce).norm(), 3.2 / 8.0) << frequency << " rad/s, " << phase;
      EXPECT_LT((mean.torque - kTorque).norm(), 1.1 / 8.0) << frequency << " rad/s, " << phase;
    }
  }
}

TEST(SteadyMean, ofNoiseAloneIsSteadyNearlyAlways) {
  SensorNoise noise;
  noise.force_stddev = 1.75;
  noise.torque_stddev = 0.1;
  std::mt19937_64 random(71);
  std::normal_distribution<double> normal;
  int steady = 0;
  constexpr int kTrials = 1000;
  for (int trial = 0; trial < kTrials; ++trial) {
    SteadyMean average({kWindow, 140}, noise);
    for (int i = 0; i < 140; ++i) {
      const Vec3 force(normal(random), normal(random), normal(random));
      const Vec3 torque(normal(random), normal(random), normal(random));
      average.add(i * kPeriod, {kForce + 1.75 * force, kTorque + 0.1 * torque});
    }
    ASSERT_TRUE(average.full());
    steady += average.steady() ? 1 : 0;
  }
  EXPECT_GT(steady, 0.93 * kTrials);  // three pairs in two quantities, each off in a hundredth
  EXPECT_LT(steady, kTrials);
}

TEST(SteadyMean, forgetsWhatIsOlderThanItsWindow) {
  SteadyMean average({kWindow}, {});
  for (int i = 0; i < 100; ++i) average.add(i * kPeriod, {i < 80 ? 9.0 * kForce : kForce, kTorque});
  EXPECT_LT((average.mean().force - kForce).norm(), 1e-12);
  EXPECT_LE(average.count(), 12);
}

TEST(SteadyMean, reachesBackForThreeSamplesWhereFewCome) {
  SteadyMean average({kWindow}, {});
  for (int i = 0; i < 2; ++i) average.add(0.02 * i, {kForce, kTorque});
  EXPECT_FALSE(average.full());
  average.add(0.04, {2.0 * kForce, kTorque});
  EXPECT_TRUE(average.full());
  EXPECT_FALSE(average.steady());
}

}  // namespace
}  // namespace smore
