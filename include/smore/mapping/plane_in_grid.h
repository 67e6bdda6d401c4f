// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/voxel_grid.h"

namespace smore {

/// The plane of a planar motion, as it cuts the voxels of a grid, at any angle.
class PlaneInGrid {
 public:
  /// Of the plane z = 0 of a frame.
  explicit PlaneInGrid(const Pose& T_plane_grid);

  /// Whether it passes the voxel with this centre [m]. Where it lies between two layers of voxels,
  /// it passes both.
  bool passes(const Vec3& center, double voxel_size) const;

  /// About how many voxels it passes, at most, of a box with so many along each axis (1 at least).
  double mostPassed(const Vec3& counts) const;

  /// Visits the voxels that it passes, of the box between two of them, both included.
  void visit(const VoxelKey& first, const VoxelKey& last, double voxel_size,
             const VoxelVisitor& visitor) const;

 private:
  double distanceOf(const Vec3& point) const { return normal_.dot(point) + offset_; }

  /// Of the voxels that it passes, the largest distance of a centre.
  double halfLayer(double voxel_size) const;

  Vec3 normal_;
  double offset_;
  int across_;  ///< the axis of the grid that is most nearly along the normal
};

}  // namespace smore
