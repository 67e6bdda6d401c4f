// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/voxel_grid.h"

namespace smore {

/// A voxel of the world map and its partner in the object map.
struct PairedVoxels {
  VoxelKey world;
  VoxelKey object;
};

/// Pairs world voxels with the object voxels that hold their centres, one to one: where two want
/// the same partner, the one whose centre lies nearer to the partner's centre keeps it (ties by
/// key), the other is left out. The result is in the order of `world_keys`, which must not repeat.
std::vector<PairedVoxels> pairVoxels(const std::vector<VoxelKey>& world_keys,
                                     const Pose& T_world_object, double voxel_size);

}  // namespace smore
