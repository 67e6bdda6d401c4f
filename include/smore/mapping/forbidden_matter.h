// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "smore/mapping/mask_grid.h"

namespace smore {

/// Where one side, the object or the world, cannot hold matter: there it would have overlapped the
/// other side's matter at a pose that was free. Made at once for a whole region, by sweeping the
/// other side's matter through it.
class ForbiddenMatter {
 public:
  /// `other`: centres of the other side's balls. `poses`: the free poses as transforms from the
  /// other side's frame to that of the side that is asked for; `region` is in the latter. Balls
  /// whose centres are nearer than `distance` [m] overlap, to the accuracy of `cell` [m]; in
  /// `planar` motion all points lie in the plane z = 0. Balls of the other side that are never
  /// centred in the region count for nothing: it must reach as far beyond all points that are asked
  /// for.
  ForbiddenMatter(const std::vector<MaskedPoint>& other,
                  const std::vector<Eigen::Isometry3f>& poses, const Eigen::AlignedBox3f& region,
                  float distance, float cell, bool planar);

  /// The hypotheses in which no ball can be centred at `point`.
  HypothesisMask at(const Eigen::Vector3f& point) const { return swept_.at(point); }

 private:
  MaskGrid swept_;
};

/// A box that holds the points with `margin` [m] to spare on all sides; empty without points.
Eigen::AlignedBox3f boxAround(const std::vector<MaskedPoint>& points, float margin);

}  // namespace smore
