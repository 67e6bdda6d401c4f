// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>

#include "smore/common/geometry.h"

namespace smore {

struct FreeSpaceParameters {
  double position_cell = 0.08;  ///< poses in one cell of this size, in units of length ...
  double angle_cell = 0.02;     ///< ... and this one count once [rad]
};

/// The poses that were free, to the accuracy of a lattice of positions and rotation vectors: one
/// pose, the centre of its cell, stands for all in it. So which poses are known does not depend on
/// the order or on the rate in which they were observed.
class FreeCells {
 public:
  using Cell = std::array<std::int32_t, 6>;  ///< of the position and of the rotation vector
  struct HashOfCell {
    std::size_t operator()(const Cell& cell) const;
  };

  explicit FreeCells(const FreeSpaceParameters& parameters) : parameters_(parameters) {}

  /// The cell that holds a pose, which must be finite.
  Cell cellOf(const Pose& T_map_object) const;

  /// The centre of the pose's cell: within half a cell of it on each axis.
  Pose centerOf(const Pose& T_map_object) const;

  /// Whether the pose, which must be finite, is the first in its cell.
  bool add(const Pose& T_map_object) { return cells_.insert(cellOf(T_map_object)).second; }

  /// Whether a pose in the same cell was free.
  bool knows(const Pose& T_map_object) const { return cells_.count(cellOf(T_map_object)) != 0; }

  /// Cells that are known.
  std::size_t count() const { return cells_.size(); }
  const FreeSpaceParameters& parameters() const { return parameters_; }

 private:
  FreeSpaceParameters parameters_;
  std::unordered_set<Cell, HashOfCell> cells_;
};

}  // namespace smore
