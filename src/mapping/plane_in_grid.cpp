// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/plane_in_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace smore {
namespace {

std::int16_t& axisOf(VoxelKey& key, int axis) {
  return *std::array<std::int16_t*, 3>{&key.x, &key.y, &key.z}[axis];
}

}  // namespace

PlaneInGrid::PlaneInGrid(const Pose& T_plane_grid)
    : normal_(T_plane_grid.linear().row(2)), offset_(T_plane_grid.translation().z()) {
  normal_.cwiseAbs().maxCoeff(&across_);
}

double PlaneInGrid::halfLayer(double voxel_size) const {
  constexpr double kHalf = 0.5 + 1e-6;  // of a plane between two layers both count
  return kHalf * voxel_size * normal_.lpNorm<1>();
}

bool PlaneInGrid::passes(const Vec3& center, double voxel_size) const {
  return std::abs(distanceOf(center)) <= halfLayer(voxel_size);
}

double PlaneInGrid::mostPassed(const Vec3& counts) const {
  return counts.prod() / counts.cwiseProduct(normal_.cwiseAbs()).maxCoeff();
}

void PlaneInGrid::visit(const VoxelKey& first, const VoxelKey& last, double voxel_size,
                        const std::function<void(const VoxelKey&)>& visitor) const {
  const double width = halfLayer(voxel_size) / std::abs(normal_[across_]);
  VoxelKey low = first;
  VoxelKey high = last;
  const double lowest = axisOf(low, across_);
  const double highest = axisOf(high, across_);
  axisOf(low, across_) = axisOf(high, across_) = 0;
  visitVoxels(low, high, [&](const VoxelKey& column) {
    const double crossing = -distanceOf(voxelCenter(column, voxel_size)) / normal_[across_];
    const double from = std::max(lowest, std::ceil((crossing - width) / voxel_size));
    const double to = std::min(highest, std::floor((crossing + width) / voxel_size));
    VoxelKey key = column;
    for (double index = from; index <= to; ++index) {
      axisOf(key, across_) = static_cast<std::int16_t>(index);
      visitor(key);
    }
  });
}

}  // namespace smore
