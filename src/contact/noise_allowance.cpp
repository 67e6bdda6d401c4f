// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/noise_allowance.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

constexpr double kFalseContactRate = 1.0 / 3600.0;  // [1/s], at rest
constexpr int kTareWindows = 10;                    // slow windows in a tare
constexpr double kFilterSettling = 5.0;             // time constants until 1 % is left

// Over n samples of period p, white noise leaves s^2 / n in the variance of a mean, and a walk of
// the bias q^2 n p / 3 between the mean and the newest value: least at n = sqrt(3 / p) s / q.
int tareSamples(const SensorNoise& noise, double slow_window) {
  const double wanted = kTareWindows * slow_window / noise.sample_period;
  if (noise.force_drift <= 0.0) return static_cast<int>(std::ceil(wanted));
  const double best = std::sqrt(3.0 / noise.sample_period) * noise.force_stddev / noise.force_drift;
  return static_cast<int>(std::ceil(std::min(wanted, best)));
}

}  // namespace

ContactSensingParameters allowForNoise(const ContactSensingParameters& parameters) {
  ContactSensingParameters result = parameters;
  const SensorNoise& noise = parameters.noise;
  ContactDetectorParameters& detector = result.detector;
  const double false_contact = kFalseContactRate * noise.sample_period;
  const auto lengthen = [](double* window, double least) { *window = std::max(*window, least); };
  lengthen(&detector.fast_window,
           noiseWindow(noise, detector.contact_force - detector.free_force, false_contact));
  lengthen(&detector.release_window, detector.fast_window);
  // A contact that lasts until the force is gone cannot be released by noise alone.
  const double hysteresis = detector.contact_force - detector.release_force;
  if (hysteresis > 0.0) {
    lengthen(&detector.release_window, noiseWindow(noise, hysteresis, false_contact));
  }
  const double slow = noiseWindow(noise, detector.free_force, kMissedFreeSpace);
  lengthen(&detector.slow_window, slow);
  lengthen(&result.line.window, slow);
  lengthen(&result.line.settle, kFilterSettling * noise.filter_time_constant);
  result.tare.samples = std::max(result.tare.samples, tareSamples(noise, slow));
  return result;
}

}  // namespace smore
