// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/planning/occupied_voxels.h"

namespace smore {

/// Bounds of the distance to the nearest occupied voxel's centre, at any point in one
/// look-up.
///
/// A dense grid over the box around the occupied voxels holds exact distances between cell centres,
/// by the separable transform of Felzenszwalb and Huttenlocher, "Distance transforms of sampled
/// functions" (Theory of Computing 8, 2012). Where voxels lie so far apart that the grid would pass
/// kMaxCells, a cell spans several voxels and the bounds are looser.
class DistanceField {
 public:
  static constexpr std::size_t kMaxCells = std::size_t{1} << 21;  ///< 8 MB, about 30 ms to fill

  explicit DistanceField(const OccupiedVoxels& voxels);

  /// Bounds of the distance [m] from a point to the nearest centre of an occupied voxel: `least`
  /// may be negative near one; both are infinite without voxels.
  struct Distance {
    double least;
    double most;
  };

  /// `point` [m] in the frame of the voxels.
  Distance at(const Vec3& point) const;

 private:
  void chooseCells(const OccupiedVoxels& voxels);
  void markOccupied(const OccupiedVoxels& voxels);
  void transformAxis(int axis);
  std::size_t indexOf(const Eigen::Vector3i& cell) const;

  Eigen::Vector3i first_ = Eigen::Vector3i::Zero();  ///< lowest cell, in cells from the origin
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();   ///< in cells
  double cell_ = 1.0;                                ///< edge length of a cell [m]
  double slack_ = 0.0;           ///< largest distance of a voxel's centre to its cell's centre [m]
  Bounds centers_;               ///< box around the centres of the occupied voxels [m]
  std::vector<float> distance_;  ///< squared cells while being filled, then [m]
};

}  // namespace smore
