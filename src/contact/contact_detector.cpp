// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/contact_detector.h"

#include <algorithm>

#include "smore/contact/sensor_noise.h"

namespace smore {
namespace {

// Sample times are multiples of the sensor period in floating point: a window of two periods must
// hold the sample that is two periods old.
constexpr double kTimeTolerance = 1e-6;

}  // namespace

ContactDetector::ContactDetector(const ContactDetectorParameters& parameters)
    : parameters_(parameters) {}

ContactState ContactDetector::process(double time, const Vec3& force, double mean_stddev) {
  samples_.emplace_back(time, force);
  const double longest = std::max(parameters_.release_window, parameters_.slow_window);
  while (time - samples_.front().first > longest + kTimeTolerance) samples_.pop_front();

  updateContact(time);
  if (in_contact_) return ContactState::kContact;
  // The slow mean says nothing about free space before its window is full.
  const bool window_full =
      time - samples_.front().first >= parameters_.slow_window - kTimeTolerance;
  static const double quantile = maxwellQuantile(kMissedFreeSpace);
  const double explained = std::min(quantile * mean_stddev, parameters_.release_force);
  const bool quiet =
      meanForce(parameters_.slow_window).norm() < std::max(parameters_.free_force, explained);
  return window_full && quiet ? ContactState::kFree : ContactState::kUnsure;
}

void ContactDetector::reset() {
  samples_.clear();
  in_contact_ = false;
  above_since_ = -1.0;
}

Vec3 ContactDetector::meanForce(double window) const {
  const double newest = samples_.back().first;
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (auto it = samples_.rbegin(); it != samples_.rend(); ++it) {
    if (newest - it->first > window + kTimeTolerance) break;
    sum += it->second;
    ++count;
  }
  return sum / count;
}

void ContactDetector::updateContact(double time) {
  if (in_contact_) {
    // The mean must not reach back before the contact's own rise.
    const double overhang = parameters_.release_window - parameters_.fast_window;
    if (time - confirmed_at_ < overhang - kTimeTolerance) return;
    in_contact_ = meanForce(parameters_.release_window).norm() >= parameters_.release_force;
    return;
  }
  if (meanForce(parameters_.fast_window).norm() < parameters_.contact_force) {
    above_since_ = -1.0;
    return;
  }
  if (above_since_ < 0.0) above_since_ = time;
  if (time - above_since_ >= parameters_.dwell - kTimeTolerance) {
    in_contact_ = true;
    confirmed_at_ = time;
    above_since_ = -1.0;
    ++contact_count_;
  }
}

}  // namespace smore
