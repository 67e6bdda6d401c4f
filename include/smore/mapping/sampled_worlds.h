// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/worlds_at_unit.h"

namespace smore {

/// 64 worlds that the evidence allows, side by side in the bits of machine words: some at each unit
/// of length that is likely. One is as likely as another.
class SampledWorlds {
 public:
  /// Without matter: nothing touches.
  SampledWorlds() = default;

  /// Parts that have no world in common.
  explicit SampledWorlds(std::vector<WorldsAtUnit> parts) : parts_(std::move(parts)) {}

  /// Makes what `touching` looks things up in, which the first call does else, and takes a moment.
  void prepareTouching() const;

  /// The worlds in which the object touches at this pose in the map frame. Once they are more than
  /// `enough`, the rest may be missing.
  HypothesisMask touching(const Eigen::Isometry3f& T_map_object,
                          int enough = kHypotheses - 1) const;

  /// Mean over the worlds of the share of the places within the object's reach, at this pose in the
  /// map frame, at which something may touch that is not known beforehand (UnknownPlaces): 1 where
  /// nothing is known.
  double unknownShareAt(const Eigen::Isometry3f& T_map_object) const;

  /// Probability that the true world is among those in the mask.
  static double shareOf(HypothesisMask mask) {
    return static_cast<double>(__builtin_popcountll(mask)) / kHypotheses;
  }

  /// By their units, the smallest first.
  const std::vector<WorldsAtUnit>& parts() const { return parts_; }

  /// The distance of two touched balls' centres at which they touch [m], in the worlds of the
  /// smallest unit. The unit tells it, before there is matter too; 0 where there are no parts.
  double contactDistance() const { return parts_.empty() ? 0.0 : parts_.front().contactDistance(); }

  /// How far from its frame's origin the object is known beforehand to hold matter [m]; 0 where
  /// nothing is known of it. It may be farther than the belief's reach.
  double knownReach() const;

 private:
  std::vector<WorldsAtUnit> parts_;
};

}  // namespace smore
