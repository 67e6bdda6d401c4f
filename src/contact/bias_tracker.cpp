// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/bias_tracker.h"

#include <cmath>

namespace smore {

BiasTracker::BiasTracker(const SensorNoise& noise, const SampleWindow& delay, const Wrench& bias,
                         double stddev)
    : noise_(noise), delay_(delay), bias_(bias), variance_(stddev * stddev) {}

void BiasTracker::observe(double time, const Wrench& unloaded, bool free) {
  if (noise_.force_drift <= 0.0) return;
  if (known_at_ < 0.0) known_at_ = time;
  newest_ = time;
  if (!free) free_since_ = -1.0;
  if (free && free_since_ < 0.0) free_since_ = time;
  recent_.push_back({time, unloaded});
  while (static_cast<int>(recent_.size()) > delay_.samples &&
         time - recent_.front().time > delay_.duration) {
    const Sample& sample = recent_.front();
    age(sample.time);
    if (free && sample.time >= free_since_) learn(sample);
    recent_.pop_front();
  }
}

double BiasTracker::stddev() const {
  const double unseen = known_at_ < 0.0 ? 0.0 : newest_ - known_at_;
  return std::sqrt(variance_ + noise_.force_drift * noise_.force_drift * unseen);
}

void BiasTracker::age(double time) {
  variance_ += noise_.force_drift * noise_.force_drift * (time - known_at_);
  known_at_ = time;
}

void BiasTracker::learn(const Sample& sample) {
  if (variance_ <= 0.0) return;
  const double noise_variance = noise_.force_stddev * noise_.force_stddev;
  const double gain = variance_ / (variance_ + noise_variance);
  bias_.force += gain * (sample.unloaded.force - bias_.force);
  bias_.torque += gain * (sample.unloaded.torque - bias_.torque);
  variance_ *= 1.0 - gain;
  learnt_at_ = sample.time;
}

}  // namespace smore
