// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace smore {

/// Well mixed 64 bits from 64 bits (the finaliser of SplitMix64, Steele et al. 2014).
inline std::uint64_t mixBits(std::uint64_t value) {
  value += 0x9E3779B97F4A7C15ULL;
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ULL;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBULL;
  return value ^ (value >> 31);
}

/// Hash of two values in this order.
inline std::uint64_t mixBits(std::uint64_t first, std::uint64_t second) {
  return mixBits(mixBits(first) ^ second);
}

/// Random numbers that depend on nothing but their address. What is drawn for one contact does not
/// shift with what was drawn before for others, so that the order of the evidence leaves no trace.
class CounterRandom {
 public:
  explicit CounterRandom(std::uint64_t address) : state_(mixBits(address)) {}

  std::uint64_t bits() { return mixBits(state_++); }

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// Uniform in [-1, 1).
  double symmetric() { return 2.0 * uniform() - 1.0; }

  /// Uniform in the cube from -1 to 1, or of two `dimensions` in its square z = 0; the last one is
  /// drawn first: as arguments of one call they would be drawn in an order that compilers choose.
  Eigen::Vector3d inCube(int dimensions = 3) {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (int axis = dimensions - 1; axis >= 0; --axis) place[axis] = symmetric();
    return place;
  }

  /// Standard normal (Box and Muller).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log1p(-uniform()));
    return radius * std::cos(2.0 * M_PI * uniform());
  }

  /// Uniform in [0, count); `count` is positive.
  int index(int count) { return static_cast<int>(uniform() * count); }

 private:
  std::uint64_t state_;
};

}  // namespace smore
