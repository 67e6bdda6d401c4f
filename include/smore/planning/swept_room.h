// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "smore/mapping/mask_grid.h"
#include "smore/mapping/worlds.h"
#include "smore/planning/risk_motion.h"
#include "smore/planning/risk_space.h"

namespace smore {

/// The room that the matter of the object has swept in each sampled world, in cells as wide as the
/// unit of length: what tells how likely it is that matter which nobody has touched lies in the way
/// of a path. Such matter is taken to be a Poisson process in the world, of an unknown rate with
/// the scale-free prior 1 / rate, that has given one surprise in the E cells swept so far; so it
/// gives none in the next n with the probability E / (E + n). A long thing that goes end first
/// enters less new room than one that goes broadside.
class SweptRoom {
 public:
  /// `motions` is a view, whose metric tells how far apart poses are looked at.
  SweptRoom(const Worlds& worlds, const RiskSpace& space, const RiskMotions& motions);

  /// A probability for each world.
  using Shares = std::array<double, kHypotheses>;

  /// In each world, how likely it is that a path of at least one state meets no matter that nobody
  /// knows of; 1 where the object has no matter yet.
  Shares noSurpriseAlong(const std::vector<RiskState>& path) const;

 private:
  using Counts = std::array<int, kHypotheses>;  ///< cells, by world
  void sweep(const RiskState& state, MaskGrid* room, Counts* entered) const;

  const RiskMotions* motions_;
  float cell_;
  std::vector<MaskedPoint> object_;  ///< about one for each cell that its matter fills
  bool planar_;
  MaskGrid room_;
  Counts swept_{};
};

}  // namespace smore
