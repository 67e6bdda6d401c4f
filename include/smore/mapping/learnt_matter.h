// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/prior.h"

namespace smore {

/// What a map that was learnt holds to be matter (P >= kOccupied), as knowledge to begin anew with:
/// what hangs together, over faces, edges or corners, is one piece, true with the mean probability
/// of its voxels. Free space is not told: a map of matter does not hold it. What is matter in
/// `known` already is left out. The largest pieces, so that there are no more than `most` with
/// those of `known`.
std::vector<Prior> learntMatter(const VoxelGrid& map, const std::vector<Prior>& known, int most);

}  // namespace smore
