// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/prior_evidence.h"

namespace smore {

/// What is known beforehand, and which of the sampled worlds hold it to be true.
struct BelievedPrior {
  PriorEvidence evidence;
  std::vector<HypothesisMask> worlds;  ///< by piece

  /// The worlds that hold one of these pieces to be true.
  HypothesisMask worldsOf(PriorMask pieces) const;

  /// The worlds in which it is known beforehand what is at this place, matter or nothing.
  HypothesisMask knowing(MapSide side, const Eigen::Vector3f& place) const;
  /// Those in which it is known that there is nothing.
  HypothesisMask knowingFree(MapSide side, const Eigen::Vector3f& place) const;

  /// Known matter that some world holds to be there, with these worlds.
  std::vector<KnownBalls> balls(MapSide side) const;
};

}  // namespace smore
