// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/surface_patch.h"

namespace smore {

/// Points of matter that joins touched places of one body: what is held in one hand is one piece.
/// Neighbours may be joined, straight, where all of the way is `allowed`: two places between which
/// there is no third, in the ball that has them at its poles (the graph of Gabriel and Sokal, 1969,
/// A new statistical approach to geographic variation analysis). Of these ways the shortest that
/// make one piece are taken, and of the others, which close rings, those up to `longest_closing`
/// [m]: the mouth of a hook is open, and the sides of a frame are whole. Places nearer than
/// `distance` [m] to one another count once, the first of them; so near to a place nothing is
/// asked. Points are at most half of it apart.
std::vector<Eigen::Vector3f> joinTouches(const std::vector<Eigen::Vector3f>& places, float distance,
                                         float longest_closing, const MatterAllowed& allowed);

}  // namespace smore
