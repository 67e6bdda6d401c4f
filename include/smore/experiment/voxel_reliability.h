// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/experiment/proper_scores.h"
#include "smore/mapping/voxel_grid.h"
#include "smore/scenario/shape.h"

namespace smore {

/// Of each stored voxel its probability, and whether the true solid comes within 0.6 of a voxel's
/// size of its centre. Map and solids are in one frame.
std::vector<Forecast> voxelForecasts(const VoxelGrid& grid, const std::vector<Shape>& truth);

/// Bins for voxels: most are nearly free, so that the first tenth is told apart further.
std::vector<double> voxelBins();

/// How far two maps of one voxel size are from one another, over the voxels that either stores; a
/// voxel that one does not store counts as the least probability that it may have (0).
struct MapDifference {
  double largest = 0.0;
  double sum = 0.0;
  int voxels = 0;
};
MapDifference differenceOf(const VoxelGrid& a, const VoxelGrid& b);

}  // namespace smore
