// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/map_score.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "smore/mapping/octomap_export.h"
#include "smore/scenario/solid_distance.h"

namespace smore {
namespace {

std::optional<double> ratio(std::int64_t part, std::int64_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

bool isOccupied(const VoxelGrid& grid, const VoxelKey& key) {
  const auto probability = grid.probability(key);
  return probability && *probability >= kOccupied;
}

Bounds common(const Bounds& a, const Bounds& b) {
  return {a.min.cwiseMax(b.min), a.max.cwiseMin(b.max)};
}

/// Counts the voxels with their centre in the solids, and those of them that are occupied.
class RecallCount {
 public:
  RecallCount(const VoxelGrid& grid, const SolidDistance& distance)
      : grid_(grid), distance_(distance) {}

  // Along a row of voxels. No surface is nearer than the distance says: what lies within it is
  // passed in one step.
  void visitRow(VoxelKey key, int last_x) {
    for (int x = key.x; x <= last_x;) {
      key.x = static_cast<std::int16_t>(x);
      const double distance = distance_(voxelCenter(key, grid_.voxelSize()));
      const int alike = std::max(1, static_cast<int>(std::abs(distance) / grid_.voxelSize()));
      const int end = std::min(x + alike, last_x + 1);
      if (distance <= 0.0) countInside(key, end - x);
      x = end;
    }
  }

  std::optional<double> recall() const { return ratio(found_, inside_); }

 private:
  void countInside(VoxelKey key, int count) {
    inside_ += count;
    for (int i = 0; i < count; ++i, ++key.x) found_ += isOccupied(grid_, key) ? 1 : 0;
  }

  const VoxelGrid& grid_;
  const SolidDistance& distance_;
  std::int64_t inside_ = 0;  ///< of a large wall more than an int holds
  std::int64_t found_ = 0;
};

std::optional<double> recallOf(const VoxelGrid& grid, const SolidDistance& distance,
                               const Bounds& region) {
  if ((region.min.array() > region.max.array()).any()) return std::nullopt;
  const VoxelKey low = voxelAt(region.min, grid.voxelSize());
  const VoxelKey high = voxelAt(region.max, grid.voxelSize());
  RecallCount count(grid, distance);
  for (int y = low.y; y <= high.y; ++y) {
    for (int z = low.z; z <= high.z; ++z) {
      count.visitRow({low.x, static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)}, high.x);
    }
  }
  return count.recall();
}

}  // namespace

MapScore scoreMap(const VoxelGrid& grid, const std::vector<Shape>& truth, const Bounds& region) {
  MapScore score;
  const SolidDistance distance_to(truth);
  int near = 0;
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if (voxel.probability < kOccupied) continue;
    const double distance = distance_to(voxelCenter(voxel.key, grid.voxelSize()));
    ++score.occupied;
    if (distance <= grid.voxelSize()) ++near;
    score.distances.push_back(std::abs(distance));
  }
  score.precision = ratio(near, score.occupied);
  if (!truth.empty()) score.recall = recallOf(grid, distance_to, common(boundsOf(truth), region));
  return score;
}

MapScore scoreObjectMap(const VoxelGrid& grid, const Scenario& scene) {
  return scoreMap(grid, scene.object, boundsOf(scene.object));
}

MapScore scoreWorldMap(const VoxelGrid& grid, const Scenario& scene) {
  return scoreMap(grid, scene.environment, regionOfContacts(scene));
}

}  // namespace smore
