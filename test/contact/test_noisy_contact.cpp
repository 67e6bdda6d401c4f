// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <vector>

#include "data_sheet_noise.h"
#include "smore/contact/contact_sensing.h"

namespace smore {
namespace {

// A sensor with these errors and the sensing behind it.
class NoisyContact : public ::testing::Test {
 protected:
  NoisyContact() { hold({}, 6.0); }

  static ContactSensingParameters parameters() {
    ContactSensingParameters parameters;
    parameters.noise = dataSheet();
    return parameters;
  }

  ContactObservation read(const Wrench& contact) {
    time_ += noise_.sample_period;
    bias_ += gaussian(noise_.force_drift * std::sqrt(noise_.sample_period));
    WrenchSample sample;
    sample.time = time_;
    sample.sensor_object = sensor_object_;
    const Wrench reading{contact.force + bias_ + gaussian(noise_.force_stddev),
                         contact.torque + gaussian(noise_.torque_stddev)};
    Pose T_object_sensor = Pose::Identity();
    T_object_sensor.translation() = sensor_object_;
    sample.wrench = transformWrench(T_object_sensor, reading);
    return *sensing_.process(sample);
  }

  std::vector<ContactObservation> hold(const Wrench& contact, double duration) {
    std::vector<ContactObservation> observations;
    for (const double end = time_ + duration; time_ < end;) observations.push_back(read(contact));
    return observations;
  }

  // The wrench about the sensor of a force at a point, both in the object's axes.
  Wrench at(const Vec3& point_object, const Vec3& force) const {
    return {force, (point_object - sensor_object_).cross(force)};
  }

  Vec3 gaussian(double stddev) {
    return stddev * Vec3(normal_(random_), normal_(random_), normal_(random_));
  }

  const SensorNoise noise_ = dataSheet();
  const Vec3 sensor_object_{0.0, 0.0, -0.2};
  std::mt19937_64 random_{103};
  std::normal_distribution<double> normal_;
  double time_ = 0.0;
  Vec3 bias_{3.0, -20.0, 10.0};
  ContactSensing sensing_{parameters()};
};

TEST_F(NoisyContact, hardlyEverFeelsAContactAtRestAndMostlyKnowsThatItIsFree) {
  constexpr int kSamples = 3600000;  // two hours
  int free = 0;
  int contacts = 0;
  for (int i = 0; i < kSamples; ++i) {
    const ContactObservation observation = read({});
    if (observation.state == ContactState::kFree) ++free;
    contacts = observation.contact_id;
  }
  std::cout << contacts << " false contacts in two hours\n";
  EXPECT_LE(contacts, 6);  // one in ten minutes would be twelve
  EXPECT_GT(free, 0.95 * kSamples);
}

TEST_F(NoisyContact, findsEachContactInTimeAndGivesItsLineOnce) {
  constexpr int kTouches = 60;
  constexpr double kLatest = 0.02;  // [s] after the force has reached the threshold
  for (int touch = 1; touch <= kTouches; ++touch) {
    const Vec3 point = Vec3(0.1, 0.0, 0.0) + gaussian(0.1);
    const Vec3 force = 12.0 * gaussian(1.0).normalized();
    std::vector<ContactObservation> observations = hold(at(point, force), kLatest);
    EXPECT_EQ(observations.back().contact_id, touch);
    const auto rest = hold(at(point, force), 0.6);
    observations.insert(observations.end(), rest.begin(), rest.end());
    int lines = 0;
    for (const auto& observation : observations) {
      if (observation.line) ++lines;
    }
    EXPECT_EQ(lines, 1);
    EXPECT_EQ(observations.back().contact_id, touch);
    const auto after = hold({}, 2.0);
    EXPECT_EQ(after.back().contact_id, touch);
    int free = 0;
    for (const auto& observation : after) {
      if (observation.state == ContactState::kFree) ++free;
    }
    EXPECT_GT(free, 0);
  }
}

TEST_F(NoisyContact, linesAreAsUncertainAsTheySay) {
  constexpr int kTouches = 300;
  double direction_squares = 0.0;
  double offset_squares = 0.0;
  for (int touch = 0; touch < kTouches; ++touch) {
    const Vec3 point = Vec3(0.1, 0.1, 0.0) + gaussian(0.1);
    const Vec3 force = (6.0 + 0.05 * touch) * gaussian(1.0).normalized();
    std::optional<LineOfAction> line;
    for (const auto& observation : hold(at(point, force), 0.6)) {
      if (observation.line) line = observation.line;
    }
    ASSERT_TRUE(line);
    const Vec3 direction = force.normalized();
    const Vec3 turn = line->direction.cross(direction);
    const Vec3 nearest = point - direction * direction.dot(point);  // to the object's origin
    const Vec3 shift = line->point - nearest;
    const Vec3 across = shift - direction * direction.dot(shift);
    direction_squares += turn.squaredNorm() / 2.0 / std::pow(line->direction_stddev, 2);
    offset_squares += across.squaredNorm() / 2.0 / std::pow(line->offset_stddev, 2);
    hold({}, 1.5);
  }
  EXPECT_NEAR(std::sqrt(direction_squares / kTouches), 1.0, 0.15);
  // Stated is the larger of two axes, of which the other may have next to no error.
  EXPECT_LT(std::sqrt(offset_squares / kTouches), 1.1);
  EXPECT_GT(std::sqrt(offset_squares / kTouches), 0.6);
}

}  // namespace
}  // namespace smore
