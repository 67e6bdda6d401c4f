// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/learnt_matter.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

// The voxels of the map that hold a centre of known matter, on whatever lattice that is.
VoxelGrid placesOf(const std::vector<Prior>& known, double voxel_size) {
  VoxelGrid places(voxel_size);
  for (const Prior& prior : known) {
    for (const VoxelGrid::Voxel& voxel : prior.known.voxels()) {
      if (voxel.probability < kOccupied) continue;
      places.set(voxelAt(voxelCenter(voxel.key, prior.known.voxelSize()), voxel_size), 1.0F);
    }
  }
  return places;
}

VoxelGrid matterOf(const VoxelGrid& map, const VoxelGrid& known) {
  VoxelGrid matter(map.voxelSize());
  for (const VoxelGrid::Voxel& voxel : map.voxels()) {
    if (voxel.probability < kOccupied || known.find(voxel.key)) continue;
    matter.set(voxel.key, voxel.probability);
  }
  return matter;
}

// Positions of the voxels around one that are there, its own among them.
std::vector<std::size_t> neighbours(const VoxelGrid& grid, const VoxelKey& key) {
  std::vector<std::size_t> found;
  for (int n = 0; n < 27; ++n) {
    const auto next = neighbourOf(key, n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const auto position = next ? grid.find(*next) : std::nullopt;
    if (position) found.push_back(*position);
  }
  return found;
}

// What hangs together with the voxel at `first`; all of it is marked as seen.
Prior pieceFrom(const VoxelGrid& matter, std::size_t first, std::vector<bool>* seen) {
  Prior piece{VoxelGrid(matter.voxelSize()), 0.0};
  double sum = 0.0;
  std::vector<std::size_t> open = {first};
  (*seen)[first] = true;
  while (!open.empty()) {
    const VoxelGrid::Voxel voxel = matter.voxels()[open.back()];
    open.pop_back();
    piece.known.set(voxel.key, 1.0F);
    sum += double{voxel.probability};
    for (const std::size_t next : neighbours(matter, voxel.key)) {
      if ((*seen)[next]) continue;
      (*seen)[next] = true;
      open.push_back(next);
    }
  }
  constexpr double kSurest = 1.0 - 1e-9;  // nothing is believed beyond doubt
  piece.confidence = std::min(sum / static_cast<double>(piece.known.size()), kSurest);
  return piece;
}

}  // namespace

std::vector<Prior> learntMatter(const VoxelGrid& map, const std::vector<Prior>& known, int most) {
  const VoxelGrid matter = matterOf(map, placesOf(known, map.voxelSize()));
  std::vector<bool> seen(matter.size(), false);
  std::vector<Prior> pieces;
  for (std::size_t i = 0; i < matter.size(); ++i) {
    if (!seen[i]) pieces.push_back(pieceFrom(matter, i, &seen));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Prior& a, const Prior& b) { return a.known.size() > b.known.size(); });
  const std::size_t room = std::max(most - static_cast<int>(known.size()), 0);
  if (pieces.size() > room) pieces.erase(pieces.begin() + static_cast<long>(room), pieces.end());
  return pieces;
}

}  // namespace smore
