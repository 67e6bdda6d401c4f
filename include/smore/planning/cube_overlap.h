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
  /// negative: the least depth of overlap. Axes are tried only until one gives at least `enough`.
  /// `offset` of the second centre to the first, in the first's axes [m].
  double separation(const Vec3& offset, double enough) const;

  /// Centres at least this far apart: the cubes do not overlap, however turned [m].
  double reach() const { return reach_; }

  /// Centres nearer than this: the cubes overlap, however turned [m].
  double core() const { return edge_; }

 private:
  static constexpr int kAxes = 15;

  void add(const Vec3& axis, const Eigen::Matrix3d& rotation);

  std::array<Vec3, kAxes> axes_;     ///< of unit length
  std::array<double, kAxes> radii_;  ///< half-widths of both cubes on the axis, added [m]
  int count_ = 0;
  double edge_;
  double reach_;
};

}  // namespace smore
