// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "smore/mapping/mask_bricks.h"

namespace smore {

/// A box of cells: `side` of them along x and y, `layers` along z from its lowest cell on.
struct CellBox {
  MaskBricks::Cell lowest{};
  int side = 0;
  int layers = 0;

  std::size_t count() const { return static_cast<std::size_t>(side) * side * layers; }
  bool contains(const MaskBricks::Cell& cell) const {
    const auto within = [](int at, int count) { return at >= 0 && at < count; };
    return within(cell[0] - lowest[0], side) && within(cell[1] - lowest[1], side) &&
           within(cell[2] - lowest[2], layers);
  }
};

/// The box of that size that holds a cell, of those that fill the lattice.
CellBox boxAround(const MaskBricks::Cell& cell, int side, int layers);

/// The box with as many more cells on all sides as a ball of `radius` [cells] reaches; none above
/// and below where `flat`.
CellBox widened(const CellBox& box, float radius, bool flat);

/// Masks of all cells of a box.
class MaskBox {
 public:
  MaskBox() = default;
  explicit MaskBox(const CellBox& box) : box_(box), masks_(box.count()) {}

  const CellBox& box() const { return box_; }

  /// `cell` lies in the box.
  HypothesisMask at(const MaskBricks::Cell& cell) const { return masks_[indexOf(cell)]; }

  /// Adds to the mask of a cell; nothing where it lies outside of the box.
  void mark(const MaskBricks::Cell& cell, HypothesisMask mask) {
    if (box_.contains(cell)) masks_[indexOf(cell)] |= mask;
  }

  /// The masks of the cells along x, of one y and z counted from the lowest cell on.
  HypothesisMask* row(int y, int z) { return &masks_[rowIndex(y, z)]; }
  const HypothesisMask* row(int y, int z) const { return &masks_[rowIndex(y, z)]; }

 private:
  std::size_t rowIndex(int y, int z) const {
    return (static_cast<std::size_t>(z) * box_.side + y) * box_.side;
  }
  std::size_t indexOf(const MaskBricks::Cell& cell) const {
    return rowIndex(cell[1] - box_.lowest[1], cell[2] - box_.lowest[2]) +
           static_cast<std::size_t>(cell[0] - box_.lowest[0]);
  }

  CellBox box_;
  std::vector<HypothesisMask> masks_;
};

/// Each cell of the result holds the masks of all cells of `marked` whose centres are nearer to its
/// own than `radius` [cells], to the rounding of single precision. On all processor cores; what
/// comes out does not depend on how many there are.
MaskBricks dilated(const MaskBricks& marked, float radius);

/// The same in one box, by the thread that calls it. `marked` is of the box that is `widened` by as
/// much.
MaskBox dilated(const MaskBox& marked, float radius, bool flat, const CellBox& box);

}  // namespace smore
