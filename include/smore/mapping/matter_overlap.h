// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "smore/mapping/mask_grid.h"

namespace smore {

/// Distance of the centres of two balls at which they touch [m]: another one in each world, where
/// surfaces are known to a `spread`, in equal parts from `mean - spread` to `mean + spread`, and a
/// quarter of the mean at least.
struct TouchDistance {
  float mean;
  float spread = 0.0F;
};

/// In which worlds balls of the object and balls of the world overlap at a pose: looked up in grids
/// of the side that has more of them, point by point and in blocks of points before, many at once.
class MatterOverlap {
 public:
  /// Balls whose centres are nearer than `distance` overlap; blocks are `block` [m] wide. In
  /// `planar` motion all points lie in the plane z = 0.
  MatterOverlap(const std::vector<MaskedPoint>& object, const std::vector<MaskedPoint>& world,
                TouchDistance distance, float block, bool planar);

  /// Once they are more than `enough`, the rest may be missing.
  HypothesisMask at(const Eigen::Isometry3f& T_map_object, int enough) const;

 private:
  /// Points that lie together, looked up as one first.
  struct Block {
    MaskedPoint whole;
    int first = 0;
    int last = 0;
  };
  /// Of the blocks from `first` to before `last`; `pose` is that of the side that is looked up in
  /// the other's frame.
  void addOverlaps(std::size_t first, std::size_t last, const Eigen::Isometry3f& pose,
                   HypothesisMask* result) const;
  void makeBlocks(const std::vector<MaskedPoint>& points, float size);

  // The side with fewer points is looked up, point by point, in grids of the other side.
  bool object_moves_;
  std::vector<MaskedPoint> points_;  ///< block after block
  std::vector<Block> blocks_;
  MaskGrid near_ball_;   ///< by the centre of a ball: touches
  MaskGrid near_block_;  ///< by the centre of a block: some point of it may touch
};

}  // namespace smore
