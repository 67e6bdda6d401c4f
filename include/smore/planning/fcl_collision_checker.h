// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "smore/planning/collision_checker.h"
#include "smore/planning/voxel_overlap.h"

namespace smore {

/// FCL's octree against octree. Poses that a distance field of the world settles do not reach FCL,
/// and clearances are not FCL's.
///
/// FCL's answer without contacts calls faces that coincide a collision (its box test pads by 1e-6),
/// with contacts it does not. So the first says where there is none, and the depth of the contacts
/// decides the rest (docs/octree_planning.md).
class FclCollisionChecker : public CollisionChecker {
 public:
  /// std::invalid_argument if the voxel sizes differ or are not positive.
  FclCollisionChecker(const OccupiedVoxels& object, const OccupiedVoxels& world);
  ~FclCollisionChecker() override;

  bool inCollision(const Pose& T_world_object) const override;
  double clearance(const Pose& T_world_object, double enough) const override;
  double voxelSize() const override { return overlap_.voxelSize(); }
  double objectRadius() const override { return overlap_.objectRadius(); }

 private:
  class Trees;

  VoxelOverlap overlap_;
  std::unique_ptr<Trees> trees_;  ///< null where one of the maps has no occupied voxel
};

}  // namespace smore
