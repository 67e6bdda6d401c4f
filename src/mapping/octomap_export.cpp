// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/octomap_export.h"

#include <octomap/octomap.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace smore {
namespace {

// OctoMap's key of the voxel whose lower corner is the origin.
constexpr std::int32_t kKeyOrigin = 32768;

octomap::OcTreeKey treeKey(const VoxelKey& key) {
  return {static_cast<octomap::key_type>(key.x + kKeyOrigin),
          static_cast<octomap::key_type>(key.y + kKeyOrigin),
          static_cast<octomap::key_type>(key.z + kKeyOrigin)};
}

VoxelKey gridKey(const octomap::OcTreeKey& key) {
  return {static_cast<std::int16_t>(key[0] - kKeyOrigin),
          static_cast<std::int16_t>(key[1] - kKeyOrigin),
          static_cast<std::int16_t>(key[2] - kKeyOrigin)};
}

// OctoMap's default clamping (0.12 to 0.97) would alter most values of these maps.
constexpr double kMinProbability = 1e-6;
constexpr double kMaxProbability = 1.0 - 1e-6;

}  // namespace

std::unique_ptr<octomap::OcTree> toOctree(const VoxelGrid& grid) {
  auto tree = std::make_unique<octomap::OcTree>(grid.voxelSize());
  tree->setClampingThresMin(kMinProbability);
  tree->setClampingThresMax(kMaxProbability);
  tree->setOccupancyThres(kOccupied);
  constexpr bool kLazy = true;
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    tree->setNodeValue(treeKey(voxel.key), octomap::logodds(voxel.probability), kLazy);
  }
  tree->updateInnerOccupancy();
  return tree;
}

VoxelGrid fromOctree(const octomap::OcTree& tree) {
  VoxelGrid grid(tree.getResolution());
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    // A pruned leaf spans a cube of 2^(missing depth) voxels from its lowest key on.
    const int span = 1 << (tree.getTreeDepth() - leaf.getDepth());
    const VoxelKey low = gridKey(leaf.getIndexKey());
    const auto probability = static_cast<float>(leaf->getOccupancy());
    for (int x = 0; x < span; ++x) {
      for (int y = 0; y < span; ++y) {
        for (int z = 0; z < span; ++z) {
          grid.set({static_cast<std::int16_t>(low.x + x), static_cast<std::int16_t>(low.y + y),
                    static_cast<std::int16_t>(low.z + z)},
                   probability);
        }
      }
    }
  }
  return grid;
}

void writeOctree(const octomap::OcTree& tree, const std::string& file) {
  const std::string beside = file + ".part";
  std::ofstream stream(beside, std::ios::binary);
  (void)tree.write(stream);  // says that all is well on a full disk
  stream.close();
  std::error_code problem;
  if (stream) std::filesystem::rename(beside, file, problem);
  if (stream && !problem) return;
  std::filesystem::remove(beside, problem);
  throw std::runtime_error(file + ": cannot be written; check the disk and its permissions");
}

}  // namespace smore
