// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joined_touches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace smore {
namespace {

using Points = std::vector<Eigen::Vector3f>;

Points apart(const Points& places, float distance) {
  Points result;
  for (const Eigen::Vector3f& place : places) {
    const bool near = std::any_of(result.begin(), result.end(), [&](const Eigen::Vector3f& other) {
      return (place - other).norm() <= distance;
    });
    if (!near) result.push_back(place);
  }
  return result;
}

bool areNeighbours(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Points& points) {
  return std::none_of(points.begin(), points.end(), [&](const Eigen::Vector3f& point) {
    return (a - point).dot(b - point) < 0.0F;
  });
}

// Points of the straight way from a to b, or none where it is not allowed.
Points wayBetween(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float distance,
                  const MatterAllowed& allowed) {
  const int count = static_cast<int>(std::ceil((b - a).norm() / (0.5F * distance)));
  Points way;
  for (int i = 1; i < count; ++i) {
    const Eigen::Vector3f point = a + (b - a) * (static_cast<float>(i) / static_cast<float>(count));
    const bool at_an_end = (point - a).norm() <= distance || (point - b).norm() <= distance;
    if (!at_an_end && !allowed(point)) return {};
    way.push_back(point);
  }
  return way;
}

struct Pair {
  std::size_t a;
  std::size_t b;
  float distance;
};

// The nearest first.
std::vector<Pair> neighbours(const Points& pieces) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!areNeighbours(pieces[i], pieces[j], pieces)) continue;
      pairs.push_back({i, j, (pieces[i] - pieces[j]).norm()});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& p, const Pair& q) { return p.distance < q.distance; });
  return pairs;
}

}  // namespace

std::vector<Eigen::Vector3f> joinTouches(const std::vector<Eigen::Vector3f>& places, float distance,
                                         float longest_closing, const MatterAllowed& allowed) {
  const Points pieces = apart(places, distance);
  std::vector<std::size_t> part_of(pieces.size());  // of those joined so far, by one of its places
  std::iota(part_of.begin(), part_of.end(), 0);
  Points result;
  for (const Pair& pair : neighbours(pieces)) {
    const std::size_t part = part_of[pair.a];
    const std::size_t other = part_of[pair.b];
    if (part == other && pair.distance > longest_closing) continue;
    const Points way = wayBetween(pieces[pair.a], pieces[pair.b], distance, allowed);
    if (way.empty()) continue;
    std::replace(part_of.begin(), part_of.end(), part, other);
    result.insert(result.end(), way.begin(), way.end());
  }
  return result;
}

}  // namespace smore
