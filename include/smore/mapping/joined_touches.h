// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/surface_patch.h"

namespace smore {

/// Points of matter that joins touched places of one body: what is held in one hand is one piece.
/// The places become a tree, each tied to the nearest of those that are in it (Prim); a tie is a
/// way over one point beside the middle, drawn anew some times until all of the way is `allowed`,
/// and left out where none is. Places nearer than `distance` [m] to one another count once; so near
/// to a place nothing is asked. Points are half of it apart.
std::vector<Eigen::Vector3f> joinTouches(const std::vector<Eigen::Vector3f>& places, float distance,
                                         const MatterAllowed& allowed, CounterRandom* random);

}  // namespace smore
