// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/known_matter.h"
#include "smore/mapping/sampled_worlds.h"
#include "smore/mapping/voxel_grid.h"

namespace smore {

/// Occupancy as the sampled worlds have it on one of their sides, its frame given in that of the
/// grid. A voxel's probability is the share of the worlds with a ball that holds the voxel's
/// centre, or whose centre the voxel holds. Matter outside of the range of voxel keys is left out.
VoxelGrid marginalMap(const SampledWorlds& worlds, MapSide side, const Pose& T_grid_matter,
                      double voxel_size);

}  // namespace smore
