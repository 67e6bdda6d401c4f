// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace smore {

/// Probabilities of occupancy of a voxel in one map and of the coincident voxel in the other.
struct VoxelPair {
  double p = 0.0;
  double q = 0.0;
};

/// Occupancies after a contact that happened at one or more of `pairs`, given independent prior
/// probabilities (paper, equations 7 and 9; docs/laws.md (L2)):
///
///   p' = (p q + (1 - Pi / (1 - p q)) p (1 - q)) / (1 - Pi),   Pi = product over the pairs of (1 -
///   p q)
///
/// the exact marginal of "at least one pair is occupied in both maps". Both values of each pair are
/// updated from the same priors. Each voxel may stand in one pair only.
///
/// Pairs in [0, 1]; where Pi is 1 (the maps exclude the contact) or the list is empty there is
/// nothing to learn from and the priors come back. A pair with p q = 1 explains the contact by
/// itself: the other pairs keep their priors.
std::vector<VoxelPair> contactLaw(const std::vector<VoxelPair>& pairs);

/// Occupancies after "this pair does not touch" (paper, equation 11; docs/laws.md (L3)):
///
///   p' = p (1 - q) / (1 - p q),
///
/// and the same with p and q exchanged, both from the priors. A pair with p q = 1 contradicts the
/// observation and comes back as it is.
VoxelPair freeSpaceLaw(const VoxelPair& pair);

}  // namespace smore
