// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/wrench_sensor.h"

#include <cmath>

namespace smore {

WrenchSensor::WrenchSensor(const WrenchNoise& noise, double period, std::uint64_t seed)
    : noise_(noise), drift_step_(noise.force_drift * std::sqrt(period)), random_(seed) {}

Wrench WrenchSensor::read(const Wrench& truth) {
  drift_ += gaussian(drift_step_);
  Wrench reading;
  reading.force = truth.force + noise_.force_bias + drift_ + gaussian(noise_.force_stddev);
  reading.torque = truth.torque + noise_.torque_bias + gaussian(noise_.torque_stddev);
  return reading;
}

Vec3 WrenchSensor::gaussian(double stddev) {
  if (stddev == 0.0) return Vec3::Zero();
  Vec3 sample;
  for (double& value : sample) value = stddev * normal_(random_);
  return sample;
}

}  // namespace smore
