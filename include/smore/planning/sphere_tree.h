// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// Binary tree of spheres around points, for tests that can settle many points at once.
class SphereTree {
 public:
  struct Node {
    Vec3 center = Vec3::Zero();  ///< [m]
    double radius = 0.0;         ///< around all points below [m]; 0 at a leaf
    std::uint32_t left = 0;  ///< children in `nodes()`; 0 at a leaf (the root is nobody's child)
    std::uint32_t right = 0;
    std::uint32_t point = 0;  ///< at a leaf: position in the list of points
  };

  /// Splits at the median of the longest extent; ties by position, so that the tree is repeatable.
  explicit SphereTree(const std::vector<Vec3>& points);

  /// The root first; empty without points.
  const std::vector<Node>& nodes() const { return nodes_; }

  static bool isLeaf(const Node& node) { return node.left == 0; }

 private:
  using Positions = std::vector<std::uint32_t>;
  std::uint32_t build(const std::vector<Vec3>& points, Positions::iterator begin,
                      Positions::iterator end);

  std::vector<Node> nodes_;
};

}  // namespace smore
