// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <random>

#include "smore/common/geometry.h"
#include "smore/kinematics/wrist_sensor.h"
#include "smore/scenario/scenario.h"

namespace smore {

constexpr double kNoLowPass = std::numeric_limits<double>::infinity();  ///< a cutoff [Hz]

/// What the wrist sensor's driver gives.
struct WristReading {
  /// Exerted by the environment, gravity included, on what the sensor carries; at the origin and in
  /// the axes of the sensor's frame, with the sensor's errors.
  Wrench wrench;
  bool saturated = false;  ///< a component is at the end of the sensor's range
};

/// The errors of a force/torque sensor: on each axis white Gaussian noise, a constant bias, and on
/// the forces a bias that walks at random (steps of drift x sqrt(period) a sample); then a low-pass
/// of first order, as a controller's filter, and the end of the range.
class WrenchSensor {
 public:
  /// `period` between samples [s], positive; `cutoff` of the low-pass [Hz], positive. The errors
  /// follow from `seed`.
  WrenchSensor(const WrenchNoise& noise, double period, std::uint64_t seed,
               const WrenchRange& range = {}, double cutoff = kNoLowPass);

  /// The next sample's reading of a true wrench.
  WristReading read(const Wrench& truth);

 private:
  Vec3 gaussian(double stddev);
  Wrench filtered(const Wrench& wrench);

  WrenchNoise noise_;
  WrenchRange range_;
  double share_;                    ///< of a new value in the filtered one, in (0, 1]
  std::optional<Wrench> filtered_;  ///< nothing before the first sample
  double drift_step_;               ///< [N]
  Vec3 drift_ = Vec3::Zero();
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace smore
