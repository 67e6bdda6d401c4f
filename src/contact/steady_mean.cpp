// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/steady_mean.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace smore {
namespace {

constexpr std::size_t kParts = 3;

// A choice: what is left of a swing then is no more than what friction and the sensor leave anyway.
constexpr double kSteadyShare = 0.02;
constexpr double kSteadyOffset = 0.001;  // [m]

constexpr double kExplainedByNoise = 0.01;  // noise differs by more, in one look

}  // namespace

SteadyMean::SteadyMean(const SampleWindow& window, const SensorNoise& noise)
    : window_(window), noise_(noise) {
  window_.samples = std::max(window_.samples, static_cast<int>(kParts));
}

void SteadyMean::add(double time, const Wrench& wrench) {
  samples_.push_back({time, wrench});
  const double oldest = time - window_.duration - 0.5 * noise_.sample_period;
  while (count() > window_.samples && samples_[1].time <= oldest) samples_.pop_front();
}

bool SteadyMean::full() const {
  if (count() < window_.samples) return false;
  const double tolerance = std::min(0.5 * noise_.sample_period, 0.5 * window_.duration);
  return samples_.back().time - samples_.front().time >= window_.duration - tolerance;
}

bool SteadyMean::steady() const {
  const Wrench all = mean();
  const double force = all.force.norm();
  const Swing left = swing();
  return left.force <= kSteadyShare * force &&
         left.torque <= kSteadyShare * all.torque.norm() + kSteadyOffset * force;
}

Wrench SteadyMean::mean() const { return meanOf(0, samples_.size()); }

SteadyMean::Swing SteadyMean::swing() const {
  static const double quantile = maxwellQuantile(kExplainedByNoise);
  Swing apart;
  std::array<Wrench, kParts> parts;
  for (std::size_t i = 0; i < kParts; ++i) {
    parts[i] = meanOf(i * samples_.size() / kParts, (i + 1) * samples_.size() / kParts);
    for (std::size_t j = 0; j < i; ++j) {
      apart.force = std::max(apart.force, (parts[i].force - parts[j].force).norm());
      apart.torque = std::max(apart.torque, (parts[i].torque - parts[j].torque).norm());
    }
  }
  // Of the difference of two means over a third of the samples each.
  const double noise = quantile * std::sqrt(2.0 * kParts / static_cast<double>(samples_.size()));
  return {std::max(0.0, apart.force - noise * noise_.force_stddev),
          std::max(0.0, apart.torque - noise * noise_.torque_stddev)};
}

Wrench SteadyMean::meanOf(std::size_t begin, std::size_t end) const {
  Wrench sum;  // stays zero for a part that is empty
  for (std::size_t i = begin; i < end; ++i) {
    sum.force += samples_[i].wrench.force;
    sum.torque += samples_[i].wrench.torque;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, end - begin));
  return {sum.force / count, sum.torque / count};
}

}  // namespace smore
