// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "smore/contact/contact_detector.h"

namespace smore {
namespace {

constexpr double kPeriod = 0.002;  // the sensor's 500 Hz

// Feeds forces along z, one a sensor period, and collects the states.
class Feed {
 public:
  explicit Feed(const ContactDetectorParameters& parameters) : detector_(parameters) {}

  ContactState hold(double force, int samples) {
    ContactState state = ContactState::kUnsure;
    for (int i = 0; i < samples; ++i) state = detector_.process(kPeriod * ++n_, {0, 0, force});
    return state;
  }

  int contacts() const { return detector_.contactCount(); }

 private:
  ContactDetector detector_;
  int n_ = 0;
};

TEST(ContactDetector, saysNothingBeforeTheSlowWindowIsFull) {
  Feed feed({});
  EXPECT_EQ(feed.hold(0.0, 10), ContactState::kUnsure);
  EXPECT_EQ(feed.hold(0.0, 1), ContactState::kFree);
}

TEST(ContactDetector, isFreeBelowUnsureBetweenAndContactAtTheThreshold) {
  Feed feed({});
  EXPECT_EQ(feed.hold(0.499, 100), ContactState::kFree);
  EXPECT_EQ(feed.hold(0.5, 100), ContactState::kUnsure);
  EXPECT_EQ(feed.hold(4.999, 100), ContactState::kUnsure);
  EXPECT_EQ(feed.hold(5.0, 100), ContactState::kContact);
  EXPECT_EQ(feed.contacts(), 1);
}

TEST(ContactDetector, ignoresSpikesShorterThanTheDwell) {
  Feed feed({});
  feed.hold(0.0, 100);
  for (int i = 0; i < 20; ++i) {
    feed.hold(9.0, 2);
    EXPECT_NE(feed.hold(0.0, 20), ContactState::kContact);
  }
  EXPECT_EQ(feed.contacts(), 0);
}

TEST(ContactDetector, holdsAContactUntilTheReleaseForce) {
  Feed feed({});
  feed.hold(6.0, 10);
  EXPECT_EQ(feed.contacts(), 1);
  EXPECT_EQ(feed.hold(2.5, 50), ContactState::kContact);
  EXPECT_EQ(feed.hold(6.0, 50), ContactState::kContact);
  EXPECT_EQ(feed.contacts(), 1) << "the force never fell below the release force";
  EXPECT_EQ(feed.hold(2.4, 50), ContactState::kUnsure);
  EXPECT_EQ(feed.hold(6.0, 50), ContactState::kContact);
  EXPECT_EQ(feed.contacts(), 2);
}

// An object that swings in its grip after a stop, as a heavy one does: 12 N to and fro about 5 N.
TEST(ContactDetector, holdsAContactThroughTheNoForceOfASwing) {
  for (const double frequency : {8.0, 12.0, 40.0}) {
    Feed feed({});
    feed.hold(12.0, 10);
    for (int i = 0; i < 500; ++i) {
      const double decay = std::exp(-0.01 * i);
      const double swing = 12.0 * decay * std::cos(2.0 * M_PI * frequency * kPeriod * i);
      EXPECT_EQ(feed.hold(5.0 + swing, 1), ContactState::kContact) << frequency << " Hz " << i;
    }
    EXPECT_EQ(feed.contacts(), 1);
    EXPECT_EQ(feed.hold(0.0, 50), ContactState::kFree) << "it ends where the force stays away";
  }
}

TEST(ContactDetector, confirmsWithinTheFastWindowAndTheDwell) {
  ContactDetectorParameters parameters;
  Feed feed(parameters);
  feed.hold(0.0, 100);
  const int latency =
      static_cast<int>((parameters.fast_window.duration + parameters.dwell) / kPeriod) + 1;
  EXPECT_EQ(feed.hold(5.0, latency), ContactState::kContact);
}

TEST(ContactDetector, averagesForceVectorsSoThatNoiseCancels) {
  ContactDetectorParameters parameters;
  parameters.slow_window.duration = 0.4;
  ContactDetector detector(parameters);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.8);
  ContactState state = ContactState::kUnsure;
  for (int i = 0; i < 1000; ++i) {
    state = detector.process(kPeriod * i, {noise(random), noise(random), noise(random)});
  }
  EXPECT_EQ(state, ContactState::kFree);
  EXPECT_EQ(detector.contactCount(), 0);
}

}  // namespace
}  // namespace smore
