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
// cost more than the longer free stretches save (measured: planning_benchmark).
constexpr double kNearShare = 0.25;

/// Index of the voxel at `point`, held within the range of keys.
Eigen::Vector3i indexNear(const Vec3& point, double voxel_size) {
  const Vec3 index = (point / voxel_size).array().floor();
  return index.cwiseMax(std::numeric_limits<std::int16_t>::min())
      .cwiseMin(std::numeric_limits<std::int16_t>::max())
      .cast<int>();
}

}  // namespace

/// What one query keeps fixed.
struct VoxelOverlap::Search {
  const Pose& T_world_object;
  CubeOverlap cubes;
  bool exact;  ///< decide near voxels by the separating axis theorem
};

VoxelOverlap::VoxelOverlap(OccupiedVoxels object, OccupiedVoxels world)
    : object_(std::move(object)),
      world_(std::move(world)),
      object_tree_(centersOf(object_)),
      world_bricks_(world_.keys),
      world_field_(world_) {
  if (!(world_.voxel_size > 0.0) || object_.voxel_size != world_.voxel_size) {
    throw std::invalid_argument("object and world need one positive voxel size");
  }
  const Vec3 half = Vec3::Constant(0.5 * voxelSize());
  for (const Vec3& center : centersOf(object_)) {
    object_radius_ = std::max(object_radius_, (center.cwiseAbs() + half).norm());
  }
}

double VoxelOverlap::clearance(const Pose& T_world_object, double enough) const {
  if (isTrivial()) return kInfinity;
  const CubeOverlap cubes(T_world_object.linear(), voxelSize());
  return settle({T_world_object, cubes, true}, 0, enough);
}

double VoxelOverlap::fieldClearance(const Pose& T_world_object, double enough) const {
  if (isTrivial()) return kInfinity;
  const CubeOverlap cubes(T_world_object.linear(), voxelSize());
  // Something positive, so that 0 always means "cannot tell".
  const double least = std::max(enough, kTouchingShare * voxelSize());
  return settle({T_world_object, cubes, false}, 0, least);
}

std::set<PositionPair> VoxelOverlap::pairs(const Pose& T_world_object) const {
  std::set<PositionPair> found;
  if (isTrivial()) return found;
  VoxelGrid positions(voxelSize());
  for (const VoxelKey& key : world_.keys) positions.set(key, 1.0F);
  const CubeOverlap cubes(T_world_object.linear(), voxelSize());
  for (std::uint32_t i = 0; i < object_.keys.size(); ++i) {
    const Vec3 center = T_world_object * voxelCenter(object_.keys[i], voxelSize());
    visitNear(center, cubes.reach(), [&](const VoxelKey& key, const Vec3& offset) {
      if (cubes.separation(offset, 0.0) >= -kTouchingShare * voxelSize()) return;
      found.insert({i, static_cast<std::uint32_t>(*positions.find(key))});
    });
  }
  return found;
}

/// The clearance of the voxels below a node where it is smaller than `best`, else `best`.
double VoxelOverlap::settle(const Search& search, std::uint32_t index, double best) const {
  const SphereTree::Node& node = object_tree_.nodes()[index];
  const Vec3 center = search.T_world_object * node.center;
  const DistanceField::Distance distance = world_field_.at(center);
  const double bound = distance.least - node.radius - search.cubes.reach();
  if (bound > 0.0 && bound >= best) return best;
  if (!SphereTree::isLeaf(node)) {
    best = settle(search, node.left, best);
    return best < 0.0 ? best : settle(search, node.right, best);
  }
  if (bound > 0.0) return bound;
  const double touching = kTouchingShare * voxelSize();
  if (distance.most < search.cubes.core() - touching) return -touching;
  if (!search.exact) return 0.0;
  return measureNear(search.cubes, center, std::min(best, kNearShare * voxelSize()));
}

/// Clearance of one object voxel at `center`, looked for up to `most`.
double VoxelOverlap::measureNear(const CubeOverlap& cubes, const Vec3& center, double most) const {
  double best = most;
  visitNear(center, cubes.reach() + most, [&](const VoxelKey&, const Vec3& offset) {
    const double separation = cubes.separation(offset, best);
    const bool overlaps = separation < -kTouchingShare * voxelSize();
    best = std::min(best, overlaps ? separation : std::max(0.0, separation));
  });
  return best;
}

/// Calls `visit(key, offset)` for all voxels of the world with centres nearer than `distance` to
/// `center`, and for some further ones.
template <typename Visitor>
void VoxelOverlap::visitNear(const Vec3& center, double distance, const Visitor& visit) const {
  const Vec3 half = Vec3::Constant(distance);
  // A voxel's centre is half a voxel above the corner that its index stands for.
  const Vec3 corner = center - Vec3::Constant(0.5 * voxelSize());
  const Eigen::Vector3i low = indexNear(corner - half, voxelSize());
  const Eigen::Vector3i high = indexNear(corner + half, voxelSize());
  world_bricks_.visitBox(low, high, [&](const VoxelKey& key) {
    visit(key, Vec3(center - voxelCenter(key, voxelSize())));
  });
}

}  // namespace smore
