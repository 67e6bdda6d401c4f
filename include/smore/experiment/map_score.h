// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "smore/mapping/voxel_grid.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// How well a map agrees with the true solid. A voxel is occupied at P >= 0.5.
struct MapScore {
  int occupied = 0;  ///< occupied voxels
  /// Share of the occupied voxels whose centre lies within one voxel size of the true solid;
  /// nothing where none is occupied.
  std::optional<double> precision;
  /// Share of the voxels with their centre in the true solid and in the scored region that are
  /// occupied; nothing where there is no such voxel.
  std::optional<double> recall;
  /// Distance of each occupied voxel's centre to the true surface [m], in the grid's order.
  std::vector<double> distances;
};

/// Scores `grid` against the solids; recall is that of the `region`. All in one frame.
MapScore scoreMap(const VoxelGrid& grid, const std::vector<Shape>& truth, const Bounds& region);

/// The score of the object's map, in the object frame.
MapScore scoreObjectMap(const VoxelGrid& grid, const Scenario& scene);

/// The score of the world's map where the object can touch it (regionOfContacts).
MapScore scoreWorldMap(const VoxelGrid& grid, const Scenario& scene);

}  // namespace smore
