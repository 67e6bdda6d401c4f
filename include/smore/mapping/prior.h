// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/voxel_grid.h"

namespace smore {

/// The two maps, by what their frame is fixed to.
enum class MapSide { kObject, kWorld };

/// One piece of what is known of a map before anything is touched: matter and free space, true as a
/// whole with some probability.
struct Prior {
  /// In the world or the object frame. From kOccupied on a voxel is matter, below it is free; of a
  /// voxel that is not stored nothing is known.
  VoxelGrid known;
  double confidence = 0.999;  ///< probability that it is true, above 0 and below 1
};

/// Everything that is known beforehand. The pieces are independent of one another.
struct Priors {
  std::vector<Prior> object;
  std::vector<Prior> world;

  std::vector<Prior>& of(MapSide side) { return side == MapSide::kObject ? object : world; }
  bool empty() const { return object.empty() && world.empty(); }
};

/// Whether both say the same, in whatever order their voxels stand.
bool areTheSame(const Prior& a, const Prior& b);

}  // namespace smore
