// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// The motions of which `trail` [T_world_object] has the free poses, in their order: it is cut
/// where neighbours are farther apart than one motion's samples are, and thinned to what is fine
/// enough to move along, both measured in the unit of length `unit` [m].
std::vector<Path> freeTracks(const Path& trail, double unit);

/// Whether a track that has the pose `a` may have gone on to `b` and left that out.
bool isThinnedOut(const Pose& a, const Pose& b, double unit);

}  // namespace smore
