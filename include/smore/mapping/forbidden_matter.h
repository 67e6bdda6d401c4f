// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "smore/mapping/mask_dilation.h"
#include "smore/mapping/mask_grid.h"
#include "smore/mapping/point_index.h"

namespace smore {

/// Where one side, the object or the world, cannot hold matter: there it would have overlapped the
/// other side's matter at a pose that was free. Places that are asked for lie near one another: the
/// other side's matter is swept through a tile of a lattice when first a point in it is asked for.
class ForbiddenMatter {
 public:
  /// `other`: centres of the other side's balls. `poses`: the free poses as transforms from the
  /// other side's frame to that of the side that is asked for. Balls whose centres are nearer than
  /// `distance` [m] overlap, to the accuracy of `cell` [m]; in `planar` motion all points lie in
  /// the plane z = 0.
  ForbiddenMatter(const std::vector<MaskedPoint>& other,
                  const std::vector<Eigen::Isometry3f>& poses, float distance, float cell,
                  bool planar);

  /// The hypotheses in which no ball can be centred at `point`. Threads may ask at the same time.
  HypothesisMask at(const Eigen::Vector3f& point) const;

 private:
  struct Tile {
    std::once_flag swept;
    MaskBox matter;
  };
  struct Tiles {
    std::mutex finding;
    std::unordered_map<std::uint64_t, Tile> by_place;
  };

  Tile& tileAt(const CellBox& tile) const;
  MaskBox sweptThrough(const CellBox& tile) const;

  std::vector<MaskedPoint> other_;
  std::vector<Eigen::Isometry3f> poses_;
  std::vector<Eigen::Isometry3f> inverse_poses_;
  float radius_;  ///< of balls around centres of cells, in cells
  float cell_;
  bool planar_;
  MaskGrid lattice_;      ///< without matter
  PointIndex near_tile_;  ///< balls that may come into a tile, by its centre in their frame
  std::unique_ptr<Tiles> tiles_;
};

}  // namespace smore
