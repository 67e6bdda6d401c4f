// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "smore/contact/bias_tracker.h"
#include "smore/contact/noise_allowance.h"

namespace smore {
namespace {

TEST(MaxwellTail, agreesWithTheChiSquareTableOfThreeDegreesOfFreedom) {
  EXPECT_NEAR(maxwellTail(std::sqrt(7.8147)), 0.05, 1e-5);
  EXPECT_NEAR(maxwellTail(std::sqrt(16.2662)), 0.001, 1e-7);
  EXPECT_EQ(maxwellTail(0.0), 1.0);
  for (const double probability : {0.9, 0.01, 1e-6}) {
    EXPECT_NEAR(maxwellTail(maxwellQuantile(probability)) / probability, 1.0, 1e-9);
  }
}

TEST(NoiseSamples, areJustEnough) {
  SensorNoise noise;
  EXPECT_EQ(noiseSamples(noise, 1.0, 0.05), 1);
  noise.force_stddev = 2.0;
  const int samples = noiseSamples(noise, 1.0, 0.05);
  EXPECT_EQ(samples, std::ceil(4.0 * 7.8147));
  std::mt19937_64 random(101);
  std::normal_distribution<double> normal(0.0, 2.0 / std::sqrt(samples));
  constexpr int kMeans = 20000;
  int beyond = 0;
  for (int i = 0; i < kMeans; ++i) {
    const Vec3 mean(normal(random), normal(random), normal(random));
    if (mean.norm() > 1.0) ++beyond;
  }
  EXPECT_LT(beyond, 0.05 * kMeans + 4.0 * std::sqrt(0.05 * kMeans));
}

TEST(AllowForNoise, leavesEverythingAsItIsWithoutNoise) {
  const ContactSensingParameters given;
  const ContactSensingParameters result = allowForNoise(given);
  EXPECT_EQ(result.detector.fast_window.samples, 1);
  EXPECT_EQ(result.detector.release_window.samples, 1);
  EXPECT_EQ(result.detector.slow_window.samples, 1);
  EXPECT_EQ(result.line.window.samples, 1);
  EXPECT_EQ(result.line.settle, given.line.settle);
  EXPECT_EQ(result.tare.noise_samples, 0);
}

TEST(AllowForNoise, asksForMoreSamplesAndWaitsForTheFilter) {
  ContactSensingParameters given;
  given.noise.force_stddev = 1.75;
  given.noise.filter_time_constant = 0.01;
  const ContactSensingParameters result = allowForNoise(given);
  EXPECT_EQ(result.detector.fast_window.samples, 5);
  EXPECT_NEAR(result.detector.release_window.samples, 16, 1);
  EXPECT_NEAR(result.detector.slow_window.samples, 140, 5);
  EXPECT_EQ(result.line.window.samples, result.detector.slow_window.samples);
  EXPECT_NEAR(result.line.settle, 0.05, 1e-12);
  EXPECT_EQ(result.tare.noise_samples, 10 * result.detector.slow_window.samples);
}

// A bias that walks, read every 2 ms.
class BiasTrackerTest : public ::testing::Test {
 protected:
  static SensorNoise noise() {
    SensorNoise noise;
    noise.force_stddev = 1.75;
    noise.force_drift = 0.3;
    return noise;
  }

  Vec3 gaussian(double stddev) {
    return stddev * Vec3(normal_(random_), normal_(random_), normal_(random_));
  }

  // Lets the bias walk for `duration`; `contact` is the force on the object.
  void pass(double duration, bool free, const Vec3& contact = Vec3::Zero()) {
    const double period = noise().sample_period;
    for (const double end = time_ + duration; time_ < end; time_ += period) {
      bias_ += gaussian(noise().force_drift * std::sqrt(period));
      const Vec3 reading = bias_ + contact + gaussian(noise().force_stddev);
      tracker_.observe(time_, {reading, Vec3::Zero()}, free);
    }
  }

  std::mt19937_64 random_{102};
  std::normal_distribution<double> normal_;
  double time_ = 0.0;
  Vec3 bias_ = Vec3::Zero();
  BiasTracker tracker_{noise(), SampleWindow{0.3}, Wrench{}, 0.1};
};

TEST_F(BiasTrackerTest, followsTheDriftAsWellAsItSays) {
  pass(5.0, true);
  double squares = 0.0;
  double stated = 0.0;
  constexpr int kLooks = 400;
  for (int i = 0; i < kLooks; ++i) {
    pass(1.0, true);
    squares += (tracker_.bias().force - bias_).squaredNorm() / 3.0;
    stated += tracker_.stddev() * tracker_.stddev();
  }
  EXPECT_NEAR(std::sqrt(squares / stated), 1.0, 0.1);
}

TEST_F(BiasTrackerTest, learnsNothingFromAContactNorFromItsRise) {
  pass(5.0, true);
  const Vec3 before = tracker_.bias().force;
  pass(0.02, true, Vec3(50.0, 0.0, 0.0));  // not confirmed yet
  pass(1.0, false, Vec3(50.0, 0.0, 0.0));
  EXPECT_LT((tracker_.bias().force - before).norm(), 0.5);
  const double stated = tracker_.stddev();
  pass(1.0, false, Vec3(50.0, 0.0, 0.0));
  EXPECT_GT(tracker_.stddev(), stated);
}

TEST(BiasTracker, staysWithoutDrift) {
  SensorNoise noise;
  noise.force_stddev = 1.0;
  BiasTracker tracker(noise, {}, {Vec3(1, 2, 3), Vec3(4, 5, 6)}, 0.1);
  for (int i = 0; i < 100; ++i) tracker.observe(0.002 * i, {Vec3(9, 9, 9), Vec3::Zero()}, true);
  EXPECT_EQ(tracker.bias().force, Vec3(1, 2, 3));
  EXPECT_EQ(tracker.stddev(), 0.1);
}

}  // namespace
}  // namespace smore
