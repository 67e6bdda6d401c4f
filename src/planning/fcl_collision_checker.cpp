// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/fcl_collision_checker.h"

#include <fcl/geometry/octree/octree.h>
#include <fcl/narrowphase/collision.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <vector>

namespace smore {
namespace {

// FCL drops subtrees whose log odds are at or below its threshold of "free", which is 0 unless told
// otherwise: P = 0.5 would be lost. So its trees hold one value only, far above both thresholds.
constexpr float kPresent = 1.0F;

/// An FCL octree whose lowest voxel has index 0 on each axis. A map around its origin would lie in
/// all eight octants of OctoMap's cube of 65536 voxels, and FCL would walk down from there 64 times
/// over.
struct Tree {
  explicit Tree(const OccupiedVoxels& voxels) {
    VoxelKey lowest = voxels.keys.front();
    for (const VoxelKey& key : voxels.keys) {
      lowest = {std::min(lowest.x, key.x), std::min(lowest.y, key.y), std::min(lowest.z, key.z)};
    }
    offset = voxels.voxel_size * Vec3(lowest.x, lowest.y, lowest.z);
    auto tree = std::make_shared<octomap::OcTree>(voxels.voxel_size);
    for (const Vec3& center : centersOf(voxels)) {
      const Vec3 shifted = center - offset;
      tree->setNodeValue(shifted.x(), shifted.y(), shifted.z(), kPresent, true);
    }
    tree->updateInnerOccupancy();
    octree = std::make_shared<fcl::OcTreed>(tree);
  }

  std::shared_ptr<fcl::OcTreed> octree;
  Vec3 offset = Vec3::Zero();  ///< of the octree's origin in the map [m]
};

fcl::CollisionRequestd withContacts(std::size_t most) {
  fcl::CollisionRequestd request;
  request.num_max_contacts = most;
  request.enable_contact = true;
  return request;
}

}  // namespace

class FclCollisionChecker::Trees {
 public:
  Trees(const OccupiedVoxels& object, const OccupiedVoxels& world)
      : object_(object),
        world_(world),
        T_world_tree_(Eigen::Translation3d(world_.offset)),
        touching_(kTouchingShare * world.voxel_size) {}

  bool collide(const Pose& T_world_object) const {
    const Pose T_world_tree = T_world_object * Eigen::Translation3d(object_.offset);
    fcl::CollisionResultd result;
    return run(T_world_tree, fcl::CollisionRequestd(), &result) > 0 && collideDeeply(T_world_tree);
  }

 private:
  std::size_t run(const Pose& T_world_tree, const fcl::CollisionRequestd& request,
                  fcl::CollisionResultd* result) const {
    return fcl::collide(object_.octree.get(), T_world_tree, world_.octree.get(), T_world_tree_,
                        request, *result);
  }

  /// FCL stops at the most contacts asked for: one is nearly always deep. Where faces of many
  /// voxels coincide none may be, until all have been seen.
  bool collideDeeply(const Pose& T_world_tree) const {
    constexpr std::size_t kGrowth = 64;
    for (std::size_t most = 1;; most *= kGrowth) {
      fcl::CollisionResultd result;
      const std::size_t count = run(T_world_tree, withContacts(most), &result);
      for (std::size_t i = 0; i < count; ++i) {
        if (result.getContact(i).penetration_depth > touching_) return true;
      }
      if (count < most) return false;
    }
  }

  Tree object_;
  Tree world_;
  Pose T_world_tree_;
  double touching_;  ///< [m]
};

FclCollisionChecker::FclCollisionChecker(const OccupiedVoxels& object, const OccupiedVoxels& world)
    : overlap_(object, world) {
  // An empty tree would make FCL walk all of the other one.
  if (object.keys.empty() || world.keys.empty()) return;
  trees_ = std::make_unique<Trees>(object, world);
}

FclCollisionChecker::~FclCollisionChecker() = default;

bool FclCollisionChecker::inCollision(const Pose& T_world_object) const {
  return clearance(T_world_object, 0.0) < 0.0;
}

double FclCollisionChecker::clearance(const Pose& T_world_object, double enough) const {
  const double by_field = overlap_.fieldClearance(T_world_object, enough);
  if (by_field != 0.0 || !trees_) return by_field;
  if (trees_->collide(T_world_object)) return -kTouchingShare * voxelSize();
  // FCL does not say how far the voxels are apart.
  return enough > 0.0 ? std::max(0.0, overlap_.clearance(T_world_object, enough)) : 0.0;
}

}  // namespace smore
