// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "data_sheet_noise.h"
#include "distance_to_line.h"
#include "sensor_feed.h"
#include "smore/contact/contact_sensing.h"

namespace smore {
namespace {

const std::map<std::string, FeedFaults> kFaults{
    {"exact", {}},
    {"jitter", {0.5}},
    {"lost", {0, 0.1}},
    {"doubled", {0, 0, 0.1}},
    {"late", {0, 0, 0, 0.1}},
    {"overtaken", {0, 0, 0, 0, 0.1}},
    {"all", {0.5, 0.1, 0.1, 0.1, 0.1}},
};

SensorNoise quiet() { return {}; }

/// A sensor of some rate [Hz] and timing, and the sensing, which is told 500 Hz whatever it is.
class TimedContact {
 public:
  TimedContact(const SensorNoise& noise, double rate, const FeedFaults& faults, std::uint64_t seed)
      : rate_(rate), feed_(noise, 1.0 / rate, faults, seed), sensing_(parameters(noise)) {
    constexpr double kTareDeadline = 60.0;
    while (!sensing_.tared() && feed_.time() < kTareDeadline) step({});
    EXPECT_TRUE(sensing_.tared());
  }

  /// Feeds one period; what was said, in order.
  std::vector<ContactObservation> step(const Wrench& contact) {
    std::vector<ContactObservation> said;
    for (const WrenchSample& sample : feed_.next(contact)) {
      if (const auto observation = sensing_.process(sample)) said.push_back(*observation);
    }
    if (!said.empty()) contacts_ = said.back().contact_id;
    return said;
  }

  /// Of what is said while nothing touches for `duration` [s], the share that says so.
  double freeShare(double duration) {
    std::int64_t free = 0;
    std::int64_t all = 0;
    for (const double end = feed_.time() + duration; feed_.time() < end;) {
      for (const ContactObservation& observation : step({})) {
        ++all;
        if (observation.state == ContactState::kFree) ++free;
      }
    }
    return static_cast<double>(free) / static_cast<double>(all);
  }

  /// Touches until the line is given, and at most for 10 s; the lines given.
  std::vector<LineOfAction> touch(const Wrench& contact) {
    constexpr double kLongest = 10.0;
    std::vector<LineOfAction> lines;
    for (const double end = feed_.time() + kLongest; feed_.time() < end && lines.empty();) {
      for (const ContactObservation& observation : step(contact)) {
        if (observation.line) lines.push_back(*observation.line);
      }
    }
    return lines;
  }

  /// Lets go for as long as the bias needs to be followed again; whether free space was felt.
  bool letGo() {
    const double settle = 1.0 + 500.0 / rate_;
    return freeShare(settle) > 0.1;
  }

  /// Seconds of `contact` until it is confirmed.
  double latency(const Wrench& contact) {
    constexpr double kLongest = 10.0;
    const double begin = feed_.time();
    const int known = contacts_;
    while (contacts_ == known && feed_.time() < begin + kLongest) step(contact);
    return feed_.time() - begin;
  }

  int contacts() const { return contacts_; }

 private:
  static ContactSensingParameters parameters(const SensorNoise& noise) {
    ContactSensingParameters parameters;
    parameters.noise = noise;
    return parameters;
  }

  double rate_;
  SensorFeed feed_;
  ContactSensing sensing_;
  int contacts_ = 0;
};

class SensorTiming : public ::testing::TestWithParam<std::tuple<double, std::string>> {
 protected:
  double rate() const { return std::get<0>(GetParam()); }
  const FeedFaults& faults() const { return kFaults.at(std::get<1>(GetParam())); }
};

TEST_P(SensorTiming, aQuietSensorIsFreeWheneverNothingTouches) {
  TimedContact contact(quiet(), rate(), faults(), 201);
  contact.freeShare(0.2);  // until the window is full
  EXPECT_EQ(contact.freeShare(20.0), 1.0);
  EXPECT_EQ(contact.contacts(), 0);
}

TEST_P(SensorTiming, aQuietSensorFeelsEachTouchOnceAndGivesItsLine) {
  TimedContact contact(quiet(), rate(), faults(), 202);
  const Vec3 point(0.1, 0.25, 0.02);
  const Vec3 force(8, 3, -1);
  for (int touch = 1; touch <= 50; ++touch) {
    const auto lines = contact.touch({force, point.cross(force)});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(distanceToLine(lines[0], point), 0.0, 1e-9);
    EXPECT_TRUE(contact.letGo());
    EXPECT_EQ(contact.contacts(), touch);
  }
}

TEST_P(SensorTiming, aTouchIsConfirmedAfterAFewSamples) {
  TimedContact contact(quiet(), rate(), faults(), 203);
  const double period = 1.0 / rate();
  double sum = 0.0;
  constexpr int kTouches = 100;
  for (int touch = 0; touch < kTouches; ++touch) {
    sum += contact.latency({Vec3(0, 6, 0), Vec3::Zero()});
    EXPECT_TRUE(contact.letGo());
  }
  // The fast window, the dwell and three samples, of which a tenth may be lost or late.
  EXPECT_LT(sum / kTouches, 0.004 + 0.004 + 3.5 * period);
}

TEST_P(SensorTiming, aNoisySensorThatDriftsFeelsNothingAtRestAndMostlyKnowsThatItIsFree) {
  TimedContact contact(dataSheet(), rate(), faults(), 204);
  const bool all_faults = std::get<1>(GetParam()) == "all";
  EXPECT_GT(contact.freeShare(all_faults ? 3600.0 : 600.0), 0.97);
  EXPECT_EQ(contact.contacts(), 0);
}

TEST_P(SensorTiming, linesOfANoisySensorAreAsUncertainAsTheySay) {
  TimedContact contact(dataSheet(), rate(), faults(), 205);
  std::mt19937_64 random(206);
  std::normal_distribution<double> normal;
  constexpr int kTouches = 150;
  double direction_squares = 0.0;
  double offset_squares = 0.0;
  for (int touch = 1; touch <= kTouches; ++touch) {
    const Vec3 point = 0.2 * Vec3(normal(random), normal(random), normal(random));
    const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Vec3 force = (7.0 + 0.05 * touch) * direction;
    const auto lines = contact.touch({force, point.cross(force)});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(contact.contacts(), touch);
    const Vec3 turn = lines[0].direction.cross(direction);
    const Vec3 shift = lines[0].point - (point - direction * direction.dot(point));
    const Vec3 across = shift - direction * direction.dot(shift);
    direction_squares += turn.squaredNorm() / 2.0 / std::pow(lines[0].direction_stddev, 2);
    offset_squares += across.squaredNorm() / 2.0 / std::pow(lines[0].offset_stddev, 2);
    EXPECT_TRUE(contact.letGo());
  }
  // The bias's drift until now is in what is stated, the average is a little older.
  EXPECT_LT(std::sqrt(direction_squares / kTouches), 1.15);
  EXPECT_GT(std::sqrt(direction_squares / kTouches), 0.7);
  // Stated is the larger of two axes, of which the other may have next to no error.
  EXPECT_LT(std::sqrt(offset_squares / kTouches), 1.15);
  EXPECT_GT(std::sqrt(offset_squares / kTouches), 0.6);
}

INSTANTIATE_TEST_SUITE_P(RatesAndFaults, SensorTiming,
                         ::testing::Combine(::testing::Values(50.0, 62.5, 100.0, 125.0, 250.0,
                                                              500.0, 1000.0),
                                            ::testing::Values("exact", "jitter", "lost", "doubled",
                                                              "late", "overtaken", "all")),
                         [](const auto& instance) {
                           return std::get<1>(instance.param) + "At" +
                                  std::to_string(static_cast<int>(std::get<0>(instance.param))) +
                                  "Hertz";
                         });

}  // namespace
}  // namespace smore
