// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/planning/collision_checker.h"
#include "smore/planning/voxel_overlap.h"

namespace smore {

/// Exact checks by distance field and separating axes (voxel_overlap.h), without octrees.
class GridCollisionChecker : public CollisionChecker {
 public:
  /// std::invalid_argument if the voxel sizes differ or are not positive.
  GridCollisionChecker(const OccupiedVoxels& object, const OccupiedVoxels& world);

  bool inCollision(const Pose& T_world_object) const override;
  double clearance(const Pose& T_world_object, double enough) const override;
  double voxelSize() const override { return overlap_.voxelSize(); }
  double objectRadius() const override { return overlap_.objectRadius(); }

 private:
  VoxelOverlap overlap_;
};

}  // namespace smore
