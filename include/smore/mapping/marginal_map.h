// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/sampled_worlds.h"
#include "smore/mapping/voxel_grid.h"

namespace smore {

/// Occupancy as the sampled worlds have it on one of their sides, `matter` with its frame given in
/// that of the grid. A voxel's probability is the share of the worlds with a ball of `radius` [m]
/// that holds the voxel's centre, or whose centre the voxel holds. std::out_of_range where matter
/// lies outside of the range of voxel keys.
VoxelGrid marginalMap(const SampledWorlds& worlds, const std::vector<MaskedPoint>& matter,
                      const Pose& T_grid_matter, double radius, double voxel_size);

}  // namespace smore
