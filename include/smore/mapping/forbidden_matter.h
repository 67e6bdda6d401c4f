// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <unordered_map>
#include <vector>

#include "smore/mapping/mask_grid.h"

namespace smore {

/// Where one side, the object or the world, cannot hold matter: there it would have overlapped the
/// other side's matter at a pose that was free.
class ForbiddenMatter {
 public:
  /// `other`: centres of the other side's balls. `poses`: the free poses as transforms from the
  /// frame of the side that is asked for to the other's. Balls whose centres are nearer than
  /// `distance` [m] overlap. Answers are those at the nearest point of a lattice of `cell` [m].
  ForbiddenMatter(const std::vector<MaskedPoint>& other, std::vector<Eigen::Isometry3f> poses,
                  float distance, float cell);

  /// The hypotheses in which no ball can be centred at `point`, in the frame of the side that is
  /// asked for.
  HypothesisMask at(const Eigen::Vector3f& point);

 private:
  MaskGrid other_;
  std::vector<Eigen::Isometry3f> poses_;
  float cell_;
  std::unordered_map<std::uint64_t, HypothesisMask> known_;  ///< answers by cell
};

}  // namespace smore
