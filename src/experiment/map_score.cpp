// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/map_score.h"

#include <cmath>

#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

std::optional<double> ratio(int part, int whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / whole;
}

bool isOccupied(const VoxelGrid& grid, const VoxelKey& key) {
  const auto probability = grid.probability(key);
  return probability && *probability >= kOccupied;
}

// Recall, by visiting each voxel of the box around each solid once.
std::optional<double> recallOf(const VoxelGrid& grid, const std::vector<Shape>& truth) {
  const double size = grid.voxelSize();
  const Bounds bounds = boundsOf(truth);
  const VoxelKey low = voxelAt(bounds.min, size);
  const VoxelKey high = voxelAt(bounds.max, size);
  int inside = 0;
  int found = 0;
  for (int x = low.x; x <= high.x; ++x) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int z = low.z; z <= high.z; ++z) {
        const VoxelKey key{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                           static_cast<std::int16_t>(z)};
        if (signedDistance(truth, voxelCenter(key, size)) > 0.0) continue;
        ++inside;
        if (isOccupied(grid, key)) ++found;
      }
    }
  }
  return ratio(found, inside);
}

}  // namespace

MapScore scoreMap(const VoxelGrid& grid, const std::vector<Shape>& truth) {
  MapScore score;
  int near = 0;
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if (voxel.probability < kOccupied) continue;
    const double distance = signedDistance(truth, voxelCenter(voxel.key, grid.voxelSize()));
    ++score.occupied;
    if (distance <= grid.voxelSize()) ++near;
    score.distances.push_back(std::abs(distance));
  }
  score.precision = ratio(near, score.occupied);
  if (!truth.empty()) score.recall = recallOf(grid, truth);
  return score;
}

}  // namespace smore
