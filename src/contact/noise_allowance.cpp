// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/noise_allowance.h"

#include <algorithm>

namespace smore {
namespace {

constexpr double kFalseContactRate = 1.0 / 3600.0;  // [1/s], at rest
constexpr int kTareWindows = 10;                    // slow windows in a tare
constexpr double kFilterSettling = 5.0;             // time constants until 1 % is left

void lengthen(SampleWindow* window, int samples) {
  window->samples = std::max(window->samples, samples);
}

}  // namespace

ContactSensingParameters allowForNoise(const ContactSensingParameters& parameters) {
  ContactSensingParameters result = parameters;
  const SensorNoise& noise = parameters.noise;
  ContactDetectorParameters& detector = result.detector;
  const double false_contact = kFalseContactRate * noise.sample_period;
  lengthen(&detector.fast_window,
           noiseSamples(noise, detector.contact_force - detector.free_force, false_contact));
  lengthen(&detector.release_window, detector.fast_window.samples);
  // A contact that lasts until the force is gone cannot be released by noise alone.
  const double hysteresis = detector.contact_force - detector.release_force;
  if (hysteresis > 0.0) {
    lengthen(&detector.release_window, noiseSamples(noise, hysteresis, false_contact));
  }
  const int slow = noiseSamples(noise, detector.free_force, kMissedFreeSpace);
  lengthen(&detector.slow_window, slow);
  lengthen(&result.line.window, slow);
  result.line.settle = std::max(result.line.settle, kFilterSettling * noise.filter_time_constant);
  if (noise.force_stddev > 0.0) result.tare.noise_samples = kTareWindows * slow;
  return result;
}

}  // namespace smore
