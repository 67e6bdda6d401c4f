// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "smore/mapping/mask_grid.h"

namespace smore {

/// A ball of matter in some hypotheses, and a touch on its surface, with matter from there through
/// its centre to the other side.
struct TouchedBall {
  Eigen::Vector3f touch = Eigen::Vector3f::Zero();
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius = 0.0F;  ///< [m], not negative
  HypothesisMask mask = 0;
};

/// Those of the asked hypotheses in which no matter may be centred at a point.
using ForbiddenAt =
    std::function<HypothesisMask(const Eigen::Vector3f& point, HypothesisMask asked)>;

/// The points of a cubic lattice of `step` [m], positive, with a point at the origin, that hold
/// matter: in each hypothesis those within its balls that are reached from what is straight behind
/// the touches over neighbours within the balls at which matter is not forbidden. One lattice for
/// all hypotheses, so that they share points. `forbidden` is asked by several threads at a time.
std::vector<MaskedPoint> fillBalls(const std::vector<TouchedBall>& balls, float step,
                                   const ForbiddenAt& forbidden);

}  // namespace smore
