// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "smore/mapping/mask_bricks.h"

namespace smore {

/// A place and the hypotheses in which it holds matter.
struct MaskedPoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  HypothesisMask mask = 0;
};

/// Points merged where they fall into one cell of a lattice; the cell's centre stands for them.
class MaskedPoints {
 public:
  /// `cell` [m], positive.
  explicit MaskedPoints(float cell) : cell_(cell) {}

  void add(const Eigen::Vector3f& point, HypothesisMask mask);
  const std::vector<MaskedPoint>& points() const { return points_; }
  /// The same number for all points of one cell of a lattice of this size.
  static std::uint64_t cellKey(const Eigen::Vector3f& point, float cell);

 private:
  float cell_;
  std::vector<MaskedPoint> points_;
  std::unordered_map<std::uint64_t, std::size_t> index_;
};

/// In which hypotheses a point is near matter, to the accuracy of a lattice with a cell around the
/// origin. Memory and time grow with the matter, not with the space that it lies in.
class MaskGrid {
 public:
  MaskGrid() = default;

  /// No matter yet. `cell` [m], positive; `planar`: all matter lies in the plane z = 0, and what is
  /// more than half a cell away from it is not near.
  MaskGrid(float cell, bool planar) : inverse_cell_(1.0F / cell), bricks_(planar) {}

  /// The union of balls of `radius` around the cells that hold the points; of discs where `planar`.
  MaskGrid(const std::vector<MaskedPoint>& points, float radius, float cell, bool planar);

  /// Matter at all points in one cell.
  void mark(const Eigen::Vector3f& point, HypothesisMask mask) {
    bricks_.mark(cellOf(point.x()), cellOf(point.y()), cellOf(point.z()), mask);
  }

  /// Adds the matter of another grid with cells of the same size.
  void add(const MaskGrid& other) { bricks_.add(other.bricks_); }

  /// Turns each marked cell into a ball of `radius` [m] around its centre.
  void dilate(float radius);

  /// The cell that holds a point.
  MaskBricks::Cell cellAt(const Eigen::Vector3f& point) const {
    return {cellOf(point.x()), cellOf(point.y()), cellOf(point.z())};
  }

  HypothesisMask at(const Eigen::Vector3f& point) const {
    return bricks_.at(cellOf(point.x()), cellOf(point.y()), cellOf(point.z()));
  }

  /// What `at` says, in two steps (MaskBricks).
  MaskBricks::Place placeOf(const Eigen::Vector3f& point) const {
    return bricks_.placeOf(cellOf(point.x()), cellOf(point.y()), cellOf(point.z()));
  }
  const HypothesisMask* maskAt(const MaskBricks::Place& place) const {
    return bricks_.maskAt(place);
  }

 private:
  int cellOf(float coordinate) const {
    const float scaled = coordinate * inverse_cell_ + 0.5F;
    const int cut = static_cast<int>(scaled);
    return cut - (scaled < static_cast<float>(cut) ? 1 : 0);
  }

  float inverse_cell_ = 1.0F;
  MaskBricks bricks_;
};

}  // namespace smore
