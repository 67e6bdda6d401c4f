// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/surface_patch.h"

#include <array>
#include <cmath>
#include <utility>

namespace smore {
namespace {

using LatticePoint = std::array<int, 2>;

// The nodes of a square lattice within `radius` steps of its origin that are reached from there
// over neighbours for which `enter` says yes; it is asked once for each.
template <typename Enter>
void flood(int radius, bool planar, const Enter& enter) {
  const int width = 2 * radius + 1;
  std::vector<char> asked(static_cast<std::size_t>(width) * width, 0);
  const auto index = [&](const LatticePoint& at) {
    return (at[1] + radius) * width + at[0] + radius;
  };
  std::vector<LatticePoint> reached = {{0, 0}};
  asked[index({0, 0})] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const auto [x, y] = reached[i];
    for (const LatticePoint& next : {LatticePoint{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
      if (planar && next[1] != 0) continue;
      if (next[0] * next[0] + next[1] * next[1] > radius * radius || asked[index(next)] != 0)
        continue;
      asked[index(next)] = 1;
      if (enter(next)) reached.push_back(next);
    }
  }
}

std::array<Eigen::Vector3f, 2> tangents(const Eigen::Vector3f& normal, bool planar,
                                        CounterRandom* random) {
  if (planar) return {Eigen::Vector3f(-normal.y(), normal.x(), 0.0F), Eigen::Vector3f::UnitZ()};
  const Eigen::Vector3f first = normal.unitOrthogonal();
  const Eigen::Vector3f second = normal.cross(first);
  const auto turn = static_cast<float>(2.0 * M_PI * random->uniform());
  return {std::cos(turn) * first + std::sin(turn) * second,
          std::cos(turn) * second - std::sin(turn) * first};
}

}  // namespace

std::vector<Eigen::Vector3f> growPatch(const SurfacePatch& patch, bool planar,
                                       const MatterAllowed& allowed, CounterRandom* random) {
  std::vector<Eigen::Vector3f> points;
  const std::array<Eigen::Vector3f, 2> axes = tangents(patch.normal, planar, random);
  flood(static_cast<int>(patch.radius / patch.step), planar, [&](const LatticePoint& at) {
    const Eigen::Vector3f point = patch.center + patch.step * (static_cast<float>(at[0]) * axes[0] +
                                                               static_cast<float>(at[1]) * axes[1]);
    if (!allowed(point)) return false;
    points.push_back(point);
    return true;
  });
  return points;
}

}  // namespace smore
