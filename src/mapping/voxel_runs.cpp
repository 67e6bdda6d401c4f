// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/voxel_runs.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

// Of a run: x, y and z of its first voxel, and how many there are along x.
constexpr std::size_t kNumbersOfRun = 4;

std::vector<VoxelKey> sortedKeys(const VoxelGrid& grid, bool matter) {
  std::vector<VoxelKey> keys;
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if ((voxel.probability >= kOccupied) == matter) keys.push_back(voxel.key);
  }
  std::sort(keys.begin(), keys.end(), [](const VoxelKey& a, const VoxelKey& b) {
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
  });
  return keys;
}

bool isKey(std::int64_t index) {
  return index >= std::numeric_limits<std::int16_t>::min() &&
         index <= std::numeric_limits<std::int16_t>::max();
}

}  // namespace

std::vector<std::int32_t> runsOf(const VoxelGrid& grid, bool matter) {
  const std::vector<VoxelKey> keys = sortedKeys(grid, matter);
  std::vector<std::int32_t> runs;
  for (std::size_t first = 0, end = 0; first < keys.size(); first = end) {
    const VoxelKey& key = keys[first];
    for (end = first + 1; end < keys.size(); ++end) {
      const VoxelKey& next = keys[end];
      if (next.z != key.z || next.y != key.y || next.x - key.x != static_cast<int>(end - first)) {
        break;
      }
    }
    runs.insert(runs.end(), {key.x, key.y, key.z, static_cast<std::int32_t>(end - first)});
  }
  return runs;
}

bool setRuns(const std::vector<std::int32_t>& runs, float probability, VoxelGrid* grid) {
  if (runs.size() % kNumbersOfRun != 0) return false;
  for (std::size_t i = 0; i < runs.size(); i += kNumbersOfRun) {
    const std::int64_t x = runs[i];
    const std::int64_t last = x + runs[i + 3] - 1;
    if (last < x || !isKey(x) || !isKey(last) || !isKey(runs[i + 1]) || !isKey(runs[i + 2])) {
      return false;
    }
    VoxelKey key{0, static_cast<std::int16_t>(runs[i + 1]), static_cast<std::int16_t>(runs[i + 2])};
    for (std::int64_t at = x; at <= last; ++at) {
      key.x = static_cast<std::int16_t>(at);
      grid->set(key, probability);
    }
  }
  return true;
}

}  // namespace smore
