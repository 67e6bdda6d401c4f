// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/mask_bricks.h"

namespace smore {

/// A box of cells: `side` of them along x and y, `layers` along z from its lowest cell on, all
/// multiples of a brick's (MaskBricks).
struct CellBox {
  MaskBricks::Cell lowest;
  int side;
  int layers;
};

/// The box of that size that holds a cell, of those that fill the lattice.
CellBox boxAround(const MaskBricks::Cell& cell, int side, int layers);

/// Each cell of the result holds the masks of all cells of `marked` whose centres are nearer to its
/// own than `radius` [cells], to the rounding of single precision. On all processor cores; what
/// comes out does not depend on how many there are.
MaskBricks dilated(const MaskBricks& marked, float radius);

/// The same in one box alone, by the thread that calls it.
MaskBricks dilated(const MaskBricks& marked, float radius, const CellBox& box);

}  // namespace smore
