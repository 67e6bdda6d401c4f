// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/occupied_voxels.h"

#include <octomap/OcTree.h>

#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

/// The cube of finest voxels that one leaf stands for, from its lowest corner.
void appendLeaf(const VoxelKey& corner, int width, std::vector<VoxelKey>* keys) {
  const auto index = [](int key) { return static_cast<std::int16_t>(key); };
  for (int x = 0; x < width; ++x) {
    for (int y = 0; y < width; ++y) {
      for (int z = 0; z < width; ++z) {
        keys->push_back({index(corner.x + x), index(corner.y + y), index(corner.z + z)});
      }
    }
  }
}

}  // namespace

OccupiedVoxels occupiedVoxels(const octomap::OcTree& tree) {
  OccupiedVoxels voxels{tree.getResolution(), {}};
  if (tree.size() == 0) return voxels;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    // Log odds are floats: 0 is P = 0.5 without the rounding of a conversion back to probability.
    static_assert(kOccupied == 0.5, "the comparison of log odds with 0 is for P >= 0.5");
    if (leaf->getLogOdds() < 0.0F) continue;
    const int width = 1 << (tree.getTreeDepth() - leaf.getDepth());
    appendLeaf(gridKey(leaf.getIndexKey()), width, &voxels.keys);
  }
  return voxels;
}

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
