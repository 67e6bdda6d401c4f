// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/wrench_sensor.h"

#include <cmath>

namespace smore {

WrenchSensor::WrenchSensor(const WrenchNoise& noise, double period, std::uint64_t seed,
                           const WrenchRange& range, double cutoff)
    : noise_(noise),
      range_(range),
      share_(-std::expm1(-2.0 * M_PI * cutoff * period)),
      drift_step_(noise.force_drift * std::sqrt(period)),
      random_(seed) {}

WristReading WrenchSensor::read(const Wrench& truth) {
  drift_ += gaussian(drift_step_);
  Wrench reading;
  reading.force = truth.force + noise_.force_bias + drift_ + gaussian(noise_.force_stddev);
  reading.torque = truth.torque + noise_.torque_bias + gaussian(noise_.torque_stddev);
  reading = filtered(reading);
  const Vec3 force = reading.force.cwiseMax(-range_.force).cwiseMin(range_.force);
  const Vec3 torque = reading.torque.cwiseMax(-range_.torque).cwiseMin(range_.torque);
  return {{force, torque}, force != reading.force || torque != reading.torque};
}

Wrench WrenchSensor::filtered(const Wrench& wrench) {
  if (!filtered_ || share_ == 1.0) {
    filtered_ = wrench;
  } else {
    filtered_->force += share_ * (wrench.force - filtered_->force);
    filtered_->torque += share_ * (wrench.torque - filtered_->torque);
  }
  return *filtered_;
}

Vec3 WrenchSensor::gaussian(double stddev) {
  if (stddev == 0.0) return Vec3::Zero();
  return Vec3::NullaryExpr([&] { return stddev * normal_(random_); });
}

}  // namespace smore
