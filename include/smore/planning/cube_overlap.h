// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "smore/common/geometry.h"

namespace smore {

/// Overlap of two equal cubes, one turned against the other, as a function of the offset of their
/// centres: the separating axis theorem (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996)
/// with everything that depends on the rotation alone computed once.
class CubeOverlap {
 public:
  /// `rotation` of the second cube's axes in the first cube's; `edge` length of both [m].
  CubeOverlap(const Eigen::Matrix3d& rotation, double edge);

  /// Distance along the best separating axis [m], a lower bound of the distance of the cubes;
  /// negative: the least depth of overlap. `offset` of the second centre to the first, in the
  /// first's axes [m].
  double separation(const Vec3& offset) const;

  /// Whether no axis separates the cubes by more than `limit` [m].
  bool isCloserThan(const Vec3& offset, double limit) const;

  /// Offsets at least this long cannot overlap [m].
  double reach() const { return reach_; }

 private:
  static constexpr int kAxes = 15;

  std::array<Vec3, kAxes> axes_;     ///< of unit length
  std::array<double, kAxes> radii_;  ///< half-widths of both cubes on the axis, added [m]
  int count_ = 0;
  double reach_;
};

}  // namespace smore
