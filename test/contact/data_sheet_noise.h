// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "smore/contact/sensor_noise.h"

namespace smore {

/// The UR5e's data sheet: +-3.5 N and +-0.2 N m, taken as two standard deviations; in the field its
/// bias drifts by 3 N in five minutes.
inline SensorNoise dataSheet() {
  SensorNoise noise;
  noise.force_stddev = 1.75;
  noise.torque_stddev = 0.1;
  noise.force_drift = 3.0 / std::sqrt(300.0);
  return noise;
}

}  // namespace smore
