// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/voxel_grid.h"

namespace smore {

/// The voxels that the segment from `a` to `b` [m] passes through, in this order, each once, both
/// end voxels included. Where the segment crosses an edge or a corner exactly, it steps along x,
/// then y, then z. std::out_of_range as voxelAt.
std::vector<VoxelKey> voxelsOnSegment(const Vec3& a, const Vec3& b, double voxel_size);

}  // namespace smore
