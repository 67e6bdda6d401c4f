// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "smore/mapping/voxel_grid.h"

namespace smore {

/// Voxels of a grid, matter (P >= kOccupied) or not, as runs along x, four whole numbers each: x, y
/// and z of the first voxel, and how many there are. In an order that the grid's own leaves no
/// trace in.
std::vector<std::int32_t> runsOf(const VoxelGrid& grid, bool matter);

/// Gives the voxels of such runs this probability. False, with some of them set, where they are no
/// runs, or reach beyond the range of keys.
bool setRuns(const std::vector<std::int32_t>& runs, float probability, VoxelGrid* grid);

}  // namespace smore
