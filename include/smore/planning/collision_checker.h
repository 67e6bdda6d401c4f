// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// Says whether the object touches the world at a pose, from a snapshot of both maps.
class CollisionChecker {
 public:
  virtual ~CollisionChecker() = default;

  /// True where an occupied voxel of the object map overlaps an occupied voxel of the world map.
  /// Voxels are closed cubes shrunk by a stated epsilon, so that faces that only touch do not overlap.
  virtual bool inCollision(const Pose& T_world_object) const = 0;

  /// Largest distance of a point of an occupied object voxel to the object frame's origin [m]; 0 where
  /// there is none. A turn by a [rad] moves no point by more than a times this.
  virtual double objectRadius() const = 0;
};

}  // namespace smore
