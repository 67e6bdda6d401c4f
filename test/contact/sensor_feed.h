// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <vector>

#include "smore/contact/contact_observation.h"
#include "smore/contact/sensor_noise.h"

namespace smore {

/// What may be wrong with the timing of a sensor's samples. Probabilities are those of one sample.
struct FeedFaults {
  double jitter = 0.0;     ///< every stamp is off by up to this share of the period, to and fro
  double lost = 0.0;       ///< never comes
  double doubled = 0.0;    ///< comes twice, with the same stamp
  double late = 0.0;       ///< read up to three periods late; the next ones follow at once
  double overtaken = 0.0;  ///< comes after the next one
};

inline std::ostream& operator<<(std::ostream& out, const FeedFaults& faults) {
  return out << "jitter " << faults.jitter << ", lost " << faults.lost << ", doubled "
             << faults.doubled << ", late " << faults.late << ", overtaken " << faults.overtaken;
}

/// A force/torque sensor with noise, a bias that walks and bad timing, about the object's origin.
/// Everything follows from the seed.
class SensorFeed {
 public:
  SensorFeed(const SensorNoise& noise, double period, const FeedFaults& faults, std::uint64_t seed)
      : noise_(noise), period_(period), faults_(faults), random_(seed) {}

  /// The true time [s].
  double time() const { return static_cast<double>(ticks_) * period_; }

  /// One period later: what arrives from a sensor that feels `contact`, in the order of arrival.
  std::vector<WrenchSample> next(const Wrench& contact) {
    ++ticks_;
    WrenchSample sample;
    sample.time = stamp();
    bias_ += gaussian(noise_.force_drift * std::sqrt(period_));
    sample.wrench.force = contact.force + bias_ + gaussian(noise_.force_stddev);
    sample.wrench.torque = contact.torque + gaussian(noise_.torque_stddev);
    std::vector<WrenchSample> arrived;
    if (!happens(faults_.lost)) arrived.push_back(sample);
    if (!arrived.empty() && happens(faults_.doubled)) arrived.push_back(sample);
    if (happens(faults_.overtaken)) {
      std::swap(arrived, held_back_);
    } else {
      arrived.insert(arrived.end(), held_back_.begin(), held_back_.end());
      held_back_.clear();
    }
    return arrived;
  }

 private:
  // Stamps are taken in order, one after the other.
  double stamp() {
    constexpr double kMostPeriodsLate = 3.0;
    constexpr double kReadingTime = 1e-5;  // [s]
    double offset = faults_.jitter * (2.0 * uniform_(random_) - 1.0);
    if (happens(faults_.late)) offset += kMostPeriodsLate * uniform_(random_);
    last_stamp_ = std::max(time() + offset * period_, last_stamp_ + kReadingTime);
    return last_stamp_;
  }

  bool happens(double probability) { return probability > 0.0 && uniform_(random_) < probability; }

  Vec3 gaussian(double stddev) {
    if (stddev <= 0.0) return Vec3::Zero();
    return stddev * Vec3(normal_(random_), normal_(random_), normal_(random_));
  }

  SensorNoise noise_;
  double period_;
  FeedFaults faults_;
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
  std::normal_distribution<double> normal_;
  std::int64_t ticks_ = 0;
  double last_stamp_ = 0.0;
  Vec3 bias_{3.0, -20.0, 10.0};
  std::vector<WrenchSample> held_back_;
};

}  // namespace smore
