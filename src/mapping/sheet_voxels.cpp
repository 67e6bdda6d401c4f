// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/sheet_voxels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace smore {
namespace {

// A sheet as it lies in the grid, in voxels.
struct Slab {
  Vec3 middle;  ///< between front and back
  Vec3 normal;
  double half;    ///< of the thickness, and half a voxel
  double radius;  ///< half a voxel at least
};

Slab slabOf(const SurfaceSheet& sheet, const Pose& T_grid_sheet, double voxel_size) {
  const Vec3 normal = T_grid_sheet.linear() * sheet.normal.cast<double>();
  const Vec3 touched = T_grid_sheet * sheet.touched.cast<double>();
  const double half = 0.5 * sheet.thickness;
  return {(touched - half * normal) / voxel_size, normal, half / voxel_size + 0.5,
          std::max(sheet.radius / voxel_size, 0.5)};
}

// How far a disc with this unit normal reaches along an axis, as part of its radius.
double discExtent(double along_normal) {
  return std::sqrt(std::max(0.0, 1.0 - along_normal * along_normal));
}

struct Range {
  int first;
  int last;
};

// Voxels with their centres between two places.
Range centersBetween(double low, double high) {
  return {static_cast<int>(std::ceil(low - 0.5)), static_cast<int>(std::floor(high - 0.5))};
}

Range reachAlong(const Slab& slab, int axis) {
  const double normal = slab.normal[axis];
  const double reach = slab.radius * discExtent(normal) + slab.half * std::abs(normal);
  return centersBetween(slab.middle[axis] - reach, slab.middle[axis] + reach);
}

VoxelKey keyOf(const Eigen::Array3i& cell) {
  return {static_cast<std::int16_t>(cell.x()), static_cast<std::int16_t>(cell.y()),
          static_cast<std::int16_t>(cell.z())};
}

}  // namespace

// Columns along the axis that is nearest to the normal pass through the slab once each.
void visitSheet(const SurfaceSheet& sheet, const Pose& T_grid_sheet, double voxel_size,
                const VoxelVisitor& visitor) {
  const Slab slab = slabOf(sheet, T_grid_sheet, voxel_size);
  constexpr double kKeys = std::numeric_limits<std::int16_t>::max();
  if (slab.middle.cwiseAbs().maxCoeff() + slab.radius + slab.half >= kKeys) return;
  const Eigen::Matrix3d to_sheet = voxel_size * T_grid_sheet.linear().transpose();
  int up = 0;
  slab.normal.cwiseAbs().maxCoeff(&up);
  const int u = (up + 1) % 3;
  const int v = (up + 2) % 3;
  const auto visit = [&](const Eigen::Array3i& cell) {
    const Vec3 offset = cell.cast<double>().matrix() + Vec3::Constant(0.5) - slab.middle;
    const double beside = (offset - offset.dot(slab.normal) * slab.normal).squaredNorm();
    if (beside <= 0.25 || sheet.reaches((to_sheet * offset).cast<float>())) visitor(keyOf(cell));
  };
  visitor(keyOf(slab.middle.array().floor().cast<int>()));
  const Range along_u = reachAlong(slab, u);
  const Range along_v = reachAlong(slab, v);
  Eigen::Array3i cell;
  for (cell[u] = along_u.first; cell[u] <= along_u.last; ++cell[u]) {
    for (cell[v] = along_v.first; cell[v] <= along_v.last; ++cell[v]) {
      const double slope = (cell[u] + 0.5 - slab.middle[u]) * slab.normal[u] +
                           (cell[v] + 0.5 - slab.middle[v]) * slab.normal[v];
      const double middle = slab.middle[up] - slope / slab.normal[up];
      const double half = slab.half / std::abs(slab.normal[up]);
      const Range column = centersBetween(middle - half, middle + half);
      for (cell[up] = column.first; cell[up] <= column.last; ++cell[up]) visit(cell);
    }
  }
}

}  // namespace smore
