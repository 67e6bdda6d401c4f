// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "smore/simulation/wrench_sensor.h"

namespace smore {
namespace {

constexpr double kPeriod = 0.002;

const Wrench kTruth{Vec3(1, 2, 3), Vec3(4, 5, 6)};

TEST(WrenchSensor, withoutErrorsReadsTheTruth) {
  WrenchSensor sensor(WrenchNoise{}, kPeriod, 1);
  const Wrench reading = sensor.read(kTruth).wrench;
  EXPECT_EQ(reading.force, kTruth.force);
  EXPECT_EQ(reading.torque, kTruth.torque);
}

TEST(WrenchSensor, noiseHasTheGivenMomentsOnEachAxis) {
  WrenchNoise noise;
  noise.force_stddev = 2.0;
  noise.torque_stddev = 0.1;
  noise.force_bias = Vec3(10, -20, 30);
  noise.torque_bias = Vec3(0.1, 0.2, -0.3);
  WrenchSensor sensor(noise, kPeriod, 2);
  constexpr int kSamples = 40000;
  Vec3 sum = Vec3::Zero();
  Vec3 squares = Vec3::Zero();
  Vec3 torque_sum = Vec3::Zero();
  Vec3 torque_squares = Vec3::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const Wrench reading = sensor.read(kTruth).wrench;
    const Vec3 error = reading.force - kTruth.force - noise.force_bias;
    const Vec3 torque_error = reading.torque - kTruth.torque - noise.torque_bias;
    sum += error;
    squares += error.cwiseAbs2();
    torque_sum += torque_error;
    torque_squares += torque_error.cwiseAbs2();
  }
  // Five standard errors of the mean (1 / sqrt(n)) and of the deviation (1 / sqrt(2 n)).
  const double tolerance = 5.0 / std::sqrt(kSamples);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sum[axis] / kSamples, 0.0, 2.0 * tolerance);
    EXPECT_NEAR(std::sqrt(squares[axis] / kSamples), 2.0, 2.0 * tolerance);
    EXPECT_NEAR(torque_sum[axis] / kSamples, 0.0, 0.1 * tolerance);
    EXPECT_NEAR(std::sqrt(torque_squares[axis] / kSamples), 0.1, 0.1 * tolerance);
  }
}

// After a time t the bias has the variance drift^2 t, on each axis by itself and for any period.
TEST(WrenchSensor, driftIsARandomWalkOfTheForce) {
  constexpr int kSensors = 4000;
  constexpr double kTime = 0.1;
  WrenchNoise noise;
  noise.force_drift = 0.5;
  for (const double period : {0.002, 0.01}) {
    Vec3 squares = Vec3::Zero();
    double product = 0.0;
    for (int seed = 0; seed < kSensors; ++seed) {
      WrenchSensor sensor(noise, period, static_cast<std::uint64_t>(seed));
      Wrench reading;
      for (int i = 0; i < std::lround(kTime / period); ++i) reading = sensor.read({}).wrench;
      squares += reading.force.cwiseAbs2();
      product += reading.force.x() * reading.force.y();
      ASSERT_EQ(reading.torque, Vec3(Vec3::Zero()));
    }
    const double variance = 0.25 * kTime;
    const double tolerance = 5.0 * variance * std::sqrt(2.0 / kSensors);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(squares[axis] / kSensors, variance, tolerance);
    }
    EXPECT_NEAR(product / kSensors, 0.0, tolerance);
  }
}

TEST(WrenchSensor, theSeedDecidesTheErrors) {
  WrenchNoise noise;
  noise.force_stddev = 1.0;
  WrenchSensor a(noise, kPeriod, 7);
  WrenchSensor b(noise, kPeriod, 7);
  WrenchSensor c(noise, kPeriod, 8);
  const Vec3 first = a.read(kTruth).wrench.force;
  EXPECT_EQ(first, b.read(kTruth).wrench.force);
  EXPECT_NE(first, c.read(kTruth).wrench.force);
}

TEST(WrenchSensor, endsAtItsRangeAndSaysSo) {
  WrenchSensor sensor(WrenchNoise{}, kPeriod, 1, {50.0, 10.0});
  EXPECT_FALSE(sensor.read({Vec3(50, -50, 49), Vec3(10, -10, 0)}).saturated);
  const WristReading force = sensor.read({Vec3(-60, 70, 1), Vec3(1, 2, 3)});
  EXPECT_TRUE(force.saturated);
  EXPECT_EQ(force.wrench.force, Vec3(-50, 50, 1));
  EXPECT_EQ(force.wrench.torque, Vec3(1, 2, 3));
  const WristReading torque = sensor.read({Vec3(1, 2, 3), Vec3(0, 0, -10.1)});
  EXPECT_TRUE(torque.saturated);
  EXPECT_EQ(torque.wrench.torque, Vec3(0, 0, -10));
}

// The answer to a step after a time t is 1 - exp(-2 pi f t).
TEST(WrenchSensor, lowPassAnswersAStepExponentially) {
  constexpr double kCutoff = 20.0;  // [Hz]
  WrenchSensor sensor(WrenchNoise{}, kPeriod, 1, {}, kCutoff);
  EXPECT_EQ(sensor.read({}).wrench.force.x(), 0.0);
  for (int i = 1; i <= 50; ++i) {
    const double expected = 1.0 - std::exp(-2.0 * M_PI * kCutoff * kPeriod * i);
    const Wrench reading = sensor.read({Vec3::Ones(), Vec3::Ones()}).wrench;
    EXPECT_NEAR(reading.force.x(), expected, 1e-12);
    EXPECT_NEAR(reading.torque.z(), expected, 1e-12);
  }
}

}  // namespace
}  // namespace smore
