// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/voxel_grid.h"
#include "smore/mapping/world_sheets.h"

namespace smore {

/// Visits each voxel to whose centre a sheet comes within half a voxel along its normal, and the
/// one that holds its middle; some twice. `T_grid_sheet`: from the sheet's frame. Nothing where it
/// leaves the range of voxel keys.
void visitSheet(const SurfaceSheet& sheet, const Pose& T_grid_sheet, double voxel_size,
                const VoxelVisitor& visitor);

}  // namespace smore
