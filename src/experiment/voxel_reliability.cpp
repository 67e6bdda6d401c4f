// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/voxel_reliability.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// Just above half: the solid reaches into the voxel or lies at its face, and a corner counts less.
constexpr double kOccupiedWithin = 0.6;  // voxel sizes

}  // namespace

std::vector<Forecast> voxelForecasts(const VoxelGrid& grid, const std::vector<Shape>& truth) {
  std::vector<Forecast> forecasts;
  forecasts.reserve(grid.size());
  const double within = kOccupiedWithin * grid.voxelSize();
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    const Vec3 center = voxelCenter(voxel.key, grid.voxelSize());
    forecasts.push_back({voxel.probability, signedDistance(truth, center) <= within});
  }
  return forecasts;
}

std::vector<double> voxelBins() {
  return {0.0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
}

MapDifference differenceOf(const VoxelGrid& a, const VoxelGrid& b) {
  MapDifference difference;
  const auto count = [&difference](double gap) {
    difference.largest = std::max(difference.largest, gap);
    difference.sum += gap;
    ++difference.voxels;
  };
  for (const VoxelGrid::Voxel& voxel : a.voxels()) {
    count(std::abs(voxel.probability - b.probability(voxel.key).value_or(0.0F)));
  }
  for (const VoxelGrid::Voxel& voxel : b.voxels()) {
    if (!a.find(voxel.key)) count(voxel.probability);
  }
  return difference;
}

}  // namespace smore
