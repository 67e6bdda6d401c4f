// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/sensor_noise.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// Over half an hour at 500 a second: who needs more has a threshold that is no use.
constexpr double kMostNoiseSamples = 1e6;

}  // namespace

double maxwellTail(double length) {
  if (length <= 0.0) return 1.0;
  return std::erfc(length / M_SQRT2) +
         std::sqrt(2.0 / M_PI) * length * std::exp(-0.5 * length * length);
}

double maxwellQuantile(double probability) {
  double low = 0.0;
  double high = 40.0;  // the tail is zero in double precision beyond
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (maxwellTail(middle) > probability ? low : high) = middle;
  }
  return high;
}

int noiseSamples(const SensorNoise& noise, double error, double probability) {
  const double ratio = maxwellQuantile(probability) * noise.force_stddev / error;
  return static_cast<int>(std::clamp(std::ceil(ratio * ratio), 1.0, kMostNoiseSamples));
}

}  // namespace smore
