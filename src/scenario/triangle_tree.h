// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/scenario/shape.h"

namespace smore {

using TriangleCorners = std::array<Vec3, 3>;

TriangleCorners cornersOf(const MeshShape& mesh, const Eigen::Vector3i& triangle);

/// The normal of a triangle, as long as twice its area.
Vec3 areaVector(const TriangleCorners& corners);

/// Volume between a triangle and the origin, negative where it is clockwise from beyond; over a
/// closed surface these add up to the enclosed volume (divergence theorem).
double signedVolume(const TriangleCorners& corners);

/// The triangles of a mesh in a tree of boxes: what it is asked takes a time that grows with the
/// logarithm of their number.
class TriangleTree {
 public:
  /// At least one triangle.
  explicit TriangleTree(const MeshShape& mesh);

  /// Distance from a point to the nearest triangle [m].
  double distance(const Vec3& point) const;

  /// How often the closed surface winds around a point that is not on it: 0 outside.
  int windingNumber(const Vec3& point) const;

  /// Whether any corner's component along a direction is above `height`.
  bool reachesBeyond(const Vec3& direction, double height) const;

 private:
  std::vector<TriangleCorners> corners_;
  Eigen::KdBVH<double, 3, int> tree_;
};

}  // namespace smore
