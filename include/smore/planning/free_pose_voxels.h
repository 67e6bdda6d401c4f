// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "smore/planning/voxel_overlap.h"

namespace smore {

/// The occupied voxels of both maps.
struct TwinVoxels {
  OccupiedVoxels object;
  OccupiedVoxels world;
};

/// The voxels with P >= kOccupied that can be occupied although the object stands free at a pose.
///
/// Marginals may say that voxels of both maps overlap there. Of each such pair one voxel must be
/// free. Taking the marginals for independent, the most probable way to have it so frees the voxels
/// whose log odds log(P / (1 - P)) have the least sum: a minimum cover of the pairs, found by a
/// maximum flow.
TwinVoxels voxelsGivenFree(const VoxelGrid& object, const VoxelGrid& world,
                           const Pose& T_world_object);

/// Positions in two lists.
struct PairCover {
  std::set<std::uint32_t> left;
  std::set<std::uint32_t> right;
};

/// Positions of least total weight such that each pair has its left or its right one among them.
/// Weights are positive, one for each position that occurs in a pair (Koenig's theorem with
/// weights; Ford and Fulkerson, "Flows in networks", 1962).
PairCover lightestCover(const std::set<PositionPair>& pairs,
                        const std::vector<double>& left_weights,
                        const std::vector<double>& right_weights);

}  // namespace smore
