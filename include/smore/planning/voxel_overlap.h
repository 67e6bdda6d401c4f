// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "smore/planning/cube_overlap.h"
#include "smore/planning/distance_field.h"
#include "smore/planning/sphere_tree.h"
#include "smore/planning/voxel_bricks.h"

namespace smore {

/// An occupied voxel of the object and one of the world, by their positions in the lists.
using PositionPair = std::pair<std::uint32_t, std::uint32_t>;

/// Which occupied voxels of the object overlap which of the world, exactly and fast: spheres around
/// groups of object voxels are settled by the distance field of the world, what remains by the
/// separating axis theorem.
class VoxelOverlap {
 public:
  /// std::invalid_argument if the voxel sizes differ or are not positive.
  VoxelOverlap(OccupiedVoxels object, OccupiedVoxels world);

  /// As CollisionChecker::clearance.
  double clearance(const Pose& T_world_object, double enough) const;

  /// As `clearance`, by the distance field alone: 0 where some voxels are too near for it to tell.
  double fieldClearance(const Pose& T_world_object, double enough) const;

  /// All pairs that overlap by more than kTouchingShare, in ascending order.
  std::set<PositionPair> pairs(const Pose& T_world_object) const;

  double voxelSize() const { return world_.voxel_size; }

  /// As CollisionChecker::objectRadius.
  double objectRadius() const { return object_radius_; }

 private:
  struct Search;

  bool isTrivial() const { return object_.keys.empty() || world_.keys.empty(); }
  double settle(const Search& search, std::uint32_t node, double best) const;
  double measureNear(const CubeOverlap& cubes, const Vec3& center, double most) const;
  template <typename Visitor>
  void visitNear(const Vec3& center, double distance, const Visitor& visit) const;

  OccupiedVoxels object_;
  OccupiedVoxels world_;
  SphereTree object_tree_;
  VoxelBricks world_bricks_;
  DistanceField world_field_;
  double object_radius_ = 0.0;
};

}  // namespace smore
