// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/surface_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace smore {
namespace {

using LatticePoint = std::array<int, 2>;

// The nodes of a square lattice that are reached from its origin over neighbours for which `enter`
// says yes; it is asked once for each of those for which `inside` does, which lie within `most`
// steps along either axis.
template <typename Inside, typename Enter>
void flood(int most, const Inside& inside, const Enter& enter) {
  const int width = 2 * most + 1;
  std::vector<char> asked(static_cast<std::size_t>(width) * width, 0);
  const auto index = [&](const LatticePoint& at) { return (at[1] + most) * width + at[0] + most; };
  std::vector<LatticePoint> reached = {{0, 0}};
  asked[index({0, 0})] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const auto [x, y] = reached[i];
    for (const LatticePoint& next : {LatticePoint{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
      if (!inside(next) || asked[index(next)] != 0) continue;
      asked[index(next)] = 1;
      if (enter(next)) reached.push_back(next);
    }
  }
}

// In planar motion the tangent and the way into the matter, otherwise two tangents.
std::array<Eigen::Vector3f, 2> latticeAxes(const Eigen::Vector3f& normal, bool planar,
                                           CounterRandom* random) {
  if (planar) return {Eigen::Vector3f(-normal.y(), normal.x(), 0.0F), Eigen::Vector3f(-normal)};
  const Eigen::Vector3f first = normal.unitOrthogonal();
  const Eigen::Vector3f second = normal.cross(first);
  const auto turn = static_cast<float>(2.0 * M_PI * random->uniform());
  return {std::cos(turn) * first + std::sin(turn) * second,
          std::cos(turn) * second - std::sin(turn) * first};
}

Eigen::Vector3f pointBehind(const SurfacePatch& patch, int steps) {
  return patch.center - static_cast<float>(steps) * patch.step * patch.normal;
}

}  // namespace

std::vector<Eigen::Vector3f> growPatch(const SurfacePatch& patch, bool planar,
                                       const MatterAllowed& allowed, CounterRandom* random) {
  std::vector<Eigen::Vector3f> points;
  const std::array<Eigen::Vector3f, 2> axes = latticeAxes(patch.normal, planar, random);
  const int radius = static_cast<int>(patch.radius / patch.step);
  const int depth = planar ? patch.depth : 0;
  const auto inside = [&](const LatticePoint& at) {
    if (planar) return std::abs(at[0]) <= radius && 0 <= at[1] && at[1] <= depth;
    return at[0] * at[0] + at[1] * at[1] <= radius * radius;
  };
  flood(std::max(radius, depth), inside, [&](const LatticePoint& at) {
    const Eigen::Vector3f point = patch.center + patch.step * (static_cast<float>(at[0]) * axes[0] +
                                                               static_cast<float>(at[1]) * axes[1]);
    if (!allowed(point)) return false;
    points.push_back(point);
    return true;
  });
  if (planar) return points;
  const int behind = depthBehind(patch, allowed);
  for (int i = 1; i <= behind; ++i) points.push_back(pointBehind(patch, i));
  return points;
}

int depthBehind(const SurfacePatch& patch, const MatterAllowed& allowed) {
  int depth = 0;
  while (depth < patch.depth && allowed(pointBehind(patch, depth + 1))) ++depth;
  return depth;
}

}  // namespace smore
