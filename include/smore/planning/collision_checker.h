// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// Overlaps up to this share of the voxel size count as touching: exact arithmetic would call faces
/// that coincide neither overlapping nor apart, and rounding would choose for each pose anew.
constexpr double kTouchingShare = 1e-6;

/// Says whether the object touches the world at a pose, from a snapshot of both maps. Safe to call
/// from several threads at once.
class CollisionChecker {
 public:
  virtual ~CollisionChecker() = default;

  /// True where an occupied voxel of the object map overlaps an occupied voxel of the world map.
  /// The voxels are closed cubes; two that overlap by less than kTouchingShare of the voxel size
  /// (in the direction in which the overlap is least) only touch, which is no collision. Around the
  /// very limit, within a factor of two, implementations may differ.
  virtual bool inCollision(const Pose& T_world_object) const = 0;

  /// How far every point of the object may move from here, each in its own direction, without a
  /// collision [m]: a lower bound, 0 where nothing better is known, not looked for beyond `enough`
  /// [m, not negative]. Negative exactly where `inCollision` is true.
  virtual double clearance(const Pose& T_world_object, double enough) const = 0;

  /// Edge length of the voxels [m].
  virtual double voxelSize() const = 0;

  /// Largest distance of a point of an occupied object voxel to the object frame's origin [m]; 0
  /// where there is none. A turn by a [rad] moves no point by more than a times this.
  virtual double objectRadius() const = 0;
};

/// Whether the object can move from a pose that is free to another (as `interpolate` does) without
/// a collision. True means: no occupied voxels overlap by more than `depth` [m, positive] on the
/// way. Poses are checked until each stretch between them is free by its clearance or moves no
/// point by more than `depth` away from the nearest checked pose.
bool isMotionFree(const CollisionChecker& checker, const Pose& from, const Pose& to, double depth);

}  // namespace smore
