// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/voxel_grid.h"

namespace smore {

/// The occupied part of a map: what a collision checker needs of it.
struct OccupiedVoxels {
  double voxel_size = 0.0;  ///< [m]
  std::vector<VoxelKey> keys;
};

/// The voxels with P >= kOccupied, exactly that value included, in the order of the grid.
OccupiedVoxels occupiedVoxels(const VoxelGrid& grid);

/// Their centres [m], in the same order.
std::vector<Vec3> centersOf(const OccupiedVoxels& voxels);

}  // namespace smore
