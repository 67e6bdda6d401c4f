// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joined_touches.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::vector<Eigen::Vector3f> joinTouches(const std::vector<Eigen::Vector3f>& places, float distance,
                                         const MatterAllowed& allowed) {
  const Points pieces = apart(places, distance);
  Points result;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!areNeighbours(pieces[i], pieces[j], pieces)) continue;
      const Points way = wayBetween(pieces[i], pieces[j], distance, allowed);
      result.insert(result.end(), way.begin(), way.end());
    }
  }
  return result;
}

}  // namespace smore
