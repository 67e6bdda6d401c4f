// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "smore/planning/cube_overlap.h"
#include "smore/planning/distance_field.h"
#include "smore/planning/sphere_tree.h"

namespace smore {

/// An occupied voxel of the object and one of the world, by their positions in the lists.
using VoxelPair = std::pair<std::uint32_t, std::uint32_t>;

/// Which occupied voxels of the object overlap which of the world, exactly and fast: spheres around
/// groups of object voxels are settled by the distance field of the world, what remains by the
/// separating axis theorem.
class VoxelOverlap {
 public:
  /// std::invalid_argument if the voxel sizes differ or are not positive.
  VoxelOverlap(const OccupiedVoxels& object, const OccupiedVoxels& world);

  /// As CollisionChecker::clearance.
  double clearance(const Pose& T_world_object, double enough) const;

  /// As `clearance`, by the distance field alone: a lower bound, 0 where some voxels are too near
  /// for it to tell. Never negative.
  double fieldClearance(const Pose& T_world_object, double enough) const;

  /// All pairs that overlap by more than kTouchingShare, in ascending order.
  std::set<VoxelPair> pairs(const Pose& T_world_object) const;

  double voxelSize() const { return world_.voxelSize(); }

  /// As CollisionChecker::objectRadius.
  double objectRadius() const { return object_radius_; }

 private:
  struct Search;
  using PairVisitor = std::function<void(std::uint32_t world, double separation)>;

  bool isTrivial() const;
  double settle(const Search& search, std::uint32_t node, double best) const;
  void visitNear(const Search& search, const Vec3& center, double gap,
                 const PairVisitor& visit) const;

  std::vector<Vec3> object_centers_;
  SphereTree object_;
  VoxelGrid world_;
  DistanceField field_;
  double object_radius_ = 0.0;
};

}  // namespace smore
