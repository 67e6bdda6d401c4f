// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

#include "smore/common/geometry.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// The errors of a force/torque sensor: on each axis white Gaussian noise, a constant bias, and on
/// the forces a bias that walks at random (steps of drift x sqrt(period) a sample).
class WrenchSensor {
 public:
  /// `period` between samples [s], positive. The errors follow from `seed`.
  WrenchSensor(const WrenchNoise& noise, double period, std::uint64_t seed);

  /// The next sample's reading of a true wrench.
  Wrench read(const Wrench& truth);

 private:
  Vec3 gaussian(double stddev);

  WrenchNoise noise_;
  double drift_step_;  ///< [N]
  Vec3 drift_ = Vec3::Zero();
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace smore
