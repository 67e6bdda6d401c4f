// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/contact_detector.h"

#include <algorithm>
#include <cmath>

namespace smore {

ContactDetector::ContactDetector(const ContactDetectorParameters& parameters,
                                 const SensorNoise& noise)
    : parameters_(parameters), noise_(noise), tolerance_(0.5 * noise.sample_period) {}

ContactState ContactDetector::process(double time, const Vec3& force, double bias_stddev) {
  keep(time, force);
  updateContact();
  judgeSlowMean(bias_stddev);
  if (in_contact_) return ContactState::kContact;
  return quiet_ ? ContactState::kFree : ContactState::kUnsure;
}

Vec3 ContactDetector::meanForce() const {
  return samples_.empty() ? Vec3(Vec3::Zero()) : meanOver(parameters_.release_window).force;
}

void ContactDetector::takeOff(const Vec3& force) {
  for (Sample& sample : samples_) sample.force -= force;
}

void ContactDetector::reset() {
  samples_.clear();
  in_contact_ = quiet_ = may_be_drift_ = false;
  above_since_.reset();
  below_since_.reset();
}

void ContactDetector::keep(double time, const Vec3& force) {
  if (!samples_.empty() && time - samples_.back().time > kLongestGap) {
    samples_.clear();
    above_since_.reset();
    below_since_.reset();
  }
  if (samples_.empty()) started_ = time;
  samples_.push_back({time, force});
  const SampleWindow& release = parameters_.release_window;
  const SampleWindow& slow = parameters_.slow_window;
  const double longest = std::max(release.duration, slow.duration) + tolerance_;
  const size_t most = static_cast<size_t>(std::max(release.samples, slow.samples));
  while (samples_.size() > most && time - samples_.front().time > longest) samples_.pop_front();
}

// Half of a short duration has to pass even where stamps are worse than that.
bool ContactDetector::hasPassed(double duration, double elapsed) const {
  return elapsed >= duration - std::min(tolerance_, 0.5 * duration);
}

bool ContactDetector::hasLasted(bool is_so, double dwell, std::optional<double>* since) const {
  const double time = samples_.back().time;
  if (!is_so) since->reset();
  if (is_so && !*since) *since = time;
  const bool has_lasted = is_so && hasPassed(dwell, time - **since);
  if (has_lasted) since->reset();
  return has_lasted;
}

ContactDetector::Mean ContactDetector::meanOver(const SampleWindow& window) const {
  const double oldest = samples_.back().time - window.duration - tolerance_;
  Mean mean{Vec3::Zero()};
  for (auto it = samples_.rbegin(); it != samples_.rend(); ++it) {
    if (it->time < oldest && mean.samples >= window.samples) break;
    mean.force += it->force;
    mean.since = it->time;
    ++mean.samples;
  }
  mean.force /= mean.samples;
  return mean;
}

void ContactDetector::judgeSlowMean(double bias_stddev) {
  static const double free_quantile = maxwellQuantile(kMissedFreeSpace);
  static const double drift_quantile = maxwellQuantile(kMissedDrift);
  const SampleWindow& window = parameters_.slow_window;
  const Mean slow = meanOver(window);
  const double stddev = std::hypot(noise_.force_stddev / std::sqrt(slow.samples), bias_stddev);
  const auto is_explained = [&](double quantile) {
    const double error = std::min(quantile * stddev, parameters_.release_force);
    return slow.force.norm() < std::max(parameters_.free_force, error);
  };
  // The mean says nothing before its window is full.
  const bool full =
      slow.samples >= window.samples && hasPassed(window.duration, samples_.back().time - started_);
  quiet_ = full && !in_contact_ && is_explained(free_quantile);
  may_be_drift_ = full && !in_contact_ && is_explained(drift_quantile);
}

void ContactDetector::updateContact() {
  if (in_contact_) {
    // The mean must not reach back before the contact's own rise.
    const SampleWindow& window = parameters_.release_window;
    const Mean release = meanOver(window);
    if (release.samples < window.samples || release.since < contact_since_) return;
    const bool is_below = release.force.norm() < parameters_.release_force;
    in_contact_ = !hasLasted(is_below, parameters_.release_dwell, &below_since_);
    return;
  }
  const Mean fast = meanOver(parameters_.fast_window);
  const bool is_above = fast.samples >= parameters_.fast_window.samples &&
                        fast.force.norm() >= parameters_.contact_force;
  if (!hasLasted(is_above, parameters_.dwell, &above_since_)) return;
  in_contact_ = true;
  contact_since_ = fast.since;
  ++contact_count_;
}

}  // namespace smore
