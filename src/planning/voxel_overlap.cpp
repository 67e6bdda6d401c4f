// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/voxel_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "smore/planning/collision_checker.h"

namespace smore {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Gaps between voxels are measured up to this share of the voxel size: further out, more look-ups
// cost more than the longer free stretches save.
constexpr double kNearShare = 0.25;

/// Index of the voxel at `point`, held within the range of keys.
Eigen::Vector3i indexNear(const Vec3& point, double voxel_size) {
  const Vec3 index = (point / voxel_size).array().floor();
  return index.cwiseMax(std::numeric_limits<std::int16_t>::min())
      .cwiseMin(std::numeric_limits<std::int16_t>::max())
      .cast<int>();
}

double voxelSizeOf(const OccupiedVoxels& object, const OccupiedVoxels& world) {
  if (!(world.voxel_size > 0.0) || object.voxel_size != world.voxel_size) {
    throw std::invalid_argument("object and world need one positive voxel size");
  }
  return world.voxel_size;
}

}  // namespace

/// What one query keeps fixed.
struct VoxelOverlap::Search {
  const Pose& T_world_object;
  CubeOverlap cubes;
  bool exact = true;                     ///< decide near voxels by the separating axis theorem
  std::set<VoxelPair>* found = nullptr;  ///< collects overlaps instead of stopping at the first
};

VoxelOverlap::VoxelOverlap(const OccupiedVoxels& object, const OccupiedVoxels& world)
    : object_centers_(centersOf(object)),
      object_(object_centers_),
      world_(voxelSizeOf(object, world)),
      field_(world) {
  for (const VoxelKey& key : world.keys) world_.set(key, 1.0F);
  const Vec3 half = Vec3::Constant(0.5 * voxelSize());
  for (const Vec3& center : object_centers_) {
    object_radius_ = std::max(object_radius_, (center.cwiseAbs() + half).norm());
  }
}

bool VoxelOverlap::isTrivial() const { return object_.nodes().empty() || world_.empty(); }

double VoxelOverlap::clearance(const Pose& T_world_object, double enough) const {
  if (isTrivial()) return kInfinity;
  return settle({T_world_object, CubeOverlap(T_world_object.linear(), voxelSize())}, 0, enough);
}

double VoxelOverlap::fieldClearance(const Pose& T_world_object, double enough) const {
  if (isTrivial()) return kInfinity;
  // Something positive, so that 0 always means "cannot tell".
  const double least = std::max(enough, kTouchingShare * voxelSize());
  return settle({T_world_object, CubeOverlap(T_world_object.linear(), voxelSize()), false}, 0,
                least);
}

std::set<VoxelPair> VoxelOverlap::pairs(const Pose& T_world_object) const {
  std::set<VoxelPair> found;
  if (isTrivial()) return found;
  settle({T_world_object, CubeOverlap(T_world_object.linear(), voxelSize()), true, &found}, 0, 0.0);
  return found;
}

/// The clearance of the voxels below a node where it is smaller than `best`, else `best`.
double VoxelOverlap::settle(const Search& search, std::uint32_t index, double best) const {
  const SphereTree::Node& node = object_.nodes()[index];
  const Vec3 center = search.T_world_object * node.center;
  const double bound = field_.lowerBound(center) - node.radius - search.cubes.reach();
  if (bound > 0.0 && bound >= best) return best;
  if (!SphereTree::isLeaf(node)) {
    best = settle(search, node.left, best);
    if (best < 0.0) return best;
    return settle(search, node.right, best);
  }
  if (bound > 0.0) return bound;
  if (!search.exact) return 0.0;
  best = std::min(best, kNearShare * voxelSize());
  visitNear(search, center, best, [&](std::uint32_t world, double separation) {
    if (separation >= -kTouchingShare * voxelSize()) {
      best = std::min(best, std::max(0.0, separation));
    } else if (search.found != nullptr) {
      search.found->insert({node.point, world});
    } else {
      best = separation;
    }
  });
  return best;
}

/// Calls `visit` for all voxels of the world that may be nearer than `gap` to an object voxel
/// centred at `center`.
void VoxelOverlap::visitNear(const Search& search, const Vec3& center, double gap,
                             const PairVisitor& visit) const {
  const double size = voxelSize();
  const Vec3 reach = Vec3::Constant(search.cubes.reach() + gap);
  const Eigen::Vector3i low = indexNear(center - reach, size);
  const Eigen::Vector3i high = indexNear(center + reach, size);
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) {
        const VoxelKey key{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                           static_cast<std::int16_t>(z)};
        const auto position = world_.find(key);
        if (!position) continue;
        visit(static_cast<std::uint32_t>(*position),
              search.cubes.separation(center - voxelCenter(key, size)));
      }
    }
  }
}

}  // namespace smore
