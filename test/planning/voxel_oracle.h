// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "smore/planning/occupied_voxels.h"

namespace smore::oracle {

/// A box as its corners and edge directions, with nothing shared with the code under test.
struct Cube {
  std::array<Vec3, 8> corners;
  std::array<Vec3, 3> edges;
};

inline Cube makeCube(const Pose& pose, const Vec3& center, double size) {
  Cube cube;
  for (int i = 0; i < 8; ++i) {
    const Vec3 signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    cube.corners[i] = pose * Vec3(center + 0.5 * size * signs);
  }
  for (int i = 0; i < 3; ++i) cube.edges[i] = pose.linear().col(i);
  return cube;
}

inline std::pair<double, double> extentAlong(const Cube& cube, const Vec3& axis) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vec3& corner : cube.corners) {
    low = std::min(low, corner.dot(axis));
    high = std::max(high, corner.dot(axis));
  }
  return {low, high};
}

/// Least translation that separates the cubes [m]; not positive where they do not overlap (then the
/// largest gap on a separating axis, negated).
inline double overlapDepth(const Cube& a, const Cube& b) {
  std::vector<Vec3> axes(a.edges.begin(), a.edges.end());
  axes.insert(axes.end(), b.edges.begin(), b.edges.end());
  for (const Vec3& u : a.edges) {
    for (const Vec3& v : b.edges) {
      if (u.cross(v).norm() > 1e-6) axes.push_back(u.cross(v).normalized());
    }
  }
  double depth = std::numeric_limits<double>::infinity();
  for (const Vec3& axis : axes) {
    const auto [a_low, a_high] = extentAlong(a, axis);
    const auto [b_low, b_high] = extentAlong(b, axis);
    depth = std::min(depth, std::min(a_high - b_low, b_high - a_low));
  }
  return depth;
}

/// Deepest overlap of any two voxels at a pose [m], by trying all pairs; -voxel size where no two
/// come near.
inline double deepestOverlap(const OccupiedVoxels& object, const OccupiedVoxels& world,
                             const Pose& T_world_object) {
  const double size = world.voxel_size;
  const double reach = 1.001 * std::sqrt(3.0) * size;  // further apart, cubes cannot meet
  const std::vector<Vec3> world_centers = centersOf(world);
  double deepest = -size;
  for (const Vec3& center : centersOf(object)) {
    const Vec3 in_world = T_world_object * center;
    for (const Vec3& other : world_centers) {
      if ((in_world - other).squaredNorm() > reach * reach) continue;
      const double depth = overlapDepth(makeCube(T_world_object, center, size),
                                        makeCube(Pose::Identity(), other, size));
      deepest = std::max(deepest, depth);
    }
  }
  return deepest;
}

/// Axis-aligned box of solid material [m].
struct Block {
  Vec3 min;
  Vec3 max;
};

/// The voxels whose centres lie in one of the blocks.
inline OccupiedVoxels voxelize(const std::vector<Block>& blocks, double size) {
  OccupiedVoxels voxels{size, {}};
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const Block& block : blocks) {
    low = low.cwiseMin(block.min);
    high = high.cwiseMax(block.max);
  }
  const VoxelKey first = voxelAt(low, size);
  const VoxelKey last = voxelAt(high, size);
  for (int x = first.x; x <= last.x; ++x) {
    for (int y = first.y; y <= last.y; ++y) {
      for (int z = first.z; z <= last.z; ++z) {
        const VoxelKey key{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                           static_cast<std::int16_t>(z)};
        const Vec3 center = voxelCenter(key, size);
        const bool inside = std::any_of(blocks.begin(), blocks.end(), [&](const Block& block) {
          return Bounds{block.min, block.max}.contains(center);
        });
        if (inside) voxels.keys.push_back(key);
      }
    }
  }
  return voxels;
}

/// Seeded poses in a cube of half-width `reach` [m]; planar ones keep z and turn about z only.
class PoseSource {
 public:
  PoseSource(unsigned seed, double reach, bool planar)
      : engine_(seed), reach_(reach), planar_(planar) {}

  Pose next() {
    const auto draw = [this](double scale) {
      return scale * std::uniform_real_distribution<double>(-1.0, 1.0)(engine_);
    };
    Pose pose = Pose::Identity();
    pose.translation() = Vec3(draw(reach_), draw(reach_), planar_ ? 0.0 : draw(reach_));
    if (planar_) {
      pose.linear() = Eigen::AngleAxisd(draw(M_PI), Vec3::UnitZ()).toRotationMatrix();
      return pose;
    }
    std::normal_distribution<double> normal;
    Eigen::Quaterniond turn(normal(engine_), normal(engine_), normal(engine_), normal(engine_));
    pose.linear() = turn.normalized().toRotationMatrix();
    return pose;
  }

 private:
  std::mt19937 engine_;
  double reach_;
  bool planar_;
};

/// The S-shape of the paper's figure 5, thinned to bars of one block each.
inline std::vector<Block> sShape() {
  return {{{-0.21, 0.27, -0.03}, {0.21, 0.33, 0.03}},
          {{-0.21, -0.03, -0.03}, {0.21, 0.03, 0.03}},
          {{-0.21, -0.33, -0.03}, {0.21, -0.27, 0.03}},
          {{-0.21, -0.03, -0.03}, {-0.15, 0.33, 0.03}},
          {{0.15, -0.33, -0.03}, {0.21, 0.03, 0.03}}};
}

inline std::vector<Block> twoPegs() {
  return {{{-0.03, 0.12, -0.15}, {0.03, 0.18, 0.15}}, {{-0.03, -0.18, -0.15}, {0.03, -0.12, 0.15}}};
}

}  // namespace smore::oracle
