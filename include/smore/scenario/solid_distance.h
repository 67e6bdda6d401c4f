// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/scenario/shape.h"

namespace smore {

class TriangleTree;

/// Signed distance to the union of solids, prepared for many points. Safe to ask from several
/// threads.
class SolidDistance {
 public:
  explicit SolidDistance(const std::vector<Shape>& shapes);

  /// Signed distance of a point [m], in the shapes' parent frame: negative inside, 0 on the
  /// surface. Inside of overlapping solids the magnitude is a lower bound of the depth. Infinity
  /// where there are no solids.
  double operator()(const Vec3& point) const;

 private:
  struct Solid {
    decltype(Shape::geometry) geometry;        ///< of a mesh without its triangles
    std::shared_ptr<const TriangleTree> tree;  ///< of a mesh only
    Pose T_solid_parent = Pose::Identity();
  };

  std::vector<Solid> solids_;
};

}  // namespace smore
