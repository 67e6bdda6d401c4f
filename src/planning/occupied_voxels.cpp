// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/occupied_voxels.h"

#include "smore/mapping/octomap_export.h"

namespace smore {

OccupiedVoxels occupiedVoxels(const VoxelGrid& grid) {
  OccupiedVoxels voxels{grid.voxelSize(), {}};
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if (voxel.probability >= kOccupied) voxels.keys.push_back(voxel.key);
  }
  return voxels;
}

std::vector<Vec3> centersOf(const OccupiedVoxels& voxels) {
  std::vector<Vec3> centers;
  centers.reserve(voxels.keys.size());
  for (const VoxelKey& key : voxels.keys) centers.push_back(voxelCenter(key, voxels.voxel_size));
  return centers;
}

}  // namespace smore
