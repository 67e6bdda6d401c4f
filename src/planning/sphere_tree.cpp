// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/sphere_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace smore {

SphereTree::SphereTree(const std::vector<Vec3>& points) {
  if (points.empty()) return;
  nodes_.reserve(2 * points.size() - 1);
  Positions positions(points.size());
  std::iota(positions.begin(), positions.end(), 0);
  build(points, positions.begin(), positions.end());
}

std::uint32_t SphereTree::build(const std::vector<Vec3>& points, Positions::iterator begin,
                                Positions::iterator end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Vec3 min = points[*begin];
  Vec3 max = min;
  for (auto it = begin; it != end; ++it) {
    min = min.cwiseMin(points[*it]);
    max = max.cwiseMax(points[*it]);
  }
  Node node;
  node.center = 0.5 * (min + max);
  node.point = *begin;
  if (end - begin > 1) {
    for (auto it = begin; it != end; ++it) {
      node.radius = std::max(node.radius, (points[*it] - node.center).norm());
    }
    int axis = 0;
    (max - min).maxCoeff(&axis);
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&points, axis](std::uint32_t a, std::uint32_t b) {
      return std::make_pair(points[a][axis], a) < std::make_pair(points[b][axis], b);
    });
    node.left = build(points, begin, middle);
    node.right = build(points, middle, end);
  }
  nodes_[index] = node;
  return index;
}

}  // namespace smore
