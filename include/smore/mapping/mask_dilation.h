// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/mask_bricks.h"

namespace smore {

/// Each cell of the result holds the masks of all cells of `marked` whose centres are nearer to its
/// own than `radius` [cells], to the rounding of single precision. On all processor cores; what
/// comes out does not depend on how many there are.
MaskBricks dilated(const MaskBricks& marked, float radius);

}  // namespace smore
