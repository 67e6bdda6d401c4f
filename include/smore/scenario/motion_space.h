// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/common/geometry.h"

namespace smore {

enum class Motion {
  kPlanar,   ///< SE(2): x, y and yaw in the plane of the start pose
  kSpatial,  ///< SE(3)
};

/// Where the object frame may be.
struct MotionSpace {
  Motion motion = Motion::kPlanar;
  Pose T_world_plane = Pose::Identity();  ///< planar: the start pose; motion is in its x-y plane
  Bounds workspace;                       ///< of the object frame's origin, in the world [m]
  /// Planar: whether the object may turn past half a turn from the start pose and so come round.
  /// The joints of an arm end somewhere.
  bool full_turns = true;

  /// Whether the origin is in the workspace and, for planar motion, the pose lies in the plane (to
  /// 1e-4 m and rad: typed numbers are rounded).
  bool contains(const Pose& T_world_object) const;

  /// The pose, in planar motion moved into the plane: an arm is never quite in it.
  Pose moved(const Pose& T_world_object) const;

  /// Whether the shorter turn between two poses of the plane keeps within that half turn, so that a
  /// straight motion may join them.
  bool allowsTurn(const Pose& T_world_from, const Pose& T_world_to) const;

  /// Whether the origin is in the workspace, or outside by no more than what rounding does to the
  /// coordinates of a tilted plane.
  bool inWorkspace(const Pose& T_world_object) const;

  /// Whether the origin is in the workspace or within 1 cm of it: an arm that was sent to its edge
  /// is never quite there.
  bool isNearWorkspace(const Pose& T_world_object) const;

  /// Whether the pose of an arm lies too far from the plane of planar motion to count as in it
  /// (isNearPlane).
  bool isBeside(const Pose& T_world_object) const;

  /// How far it lies beside the plane, in words for the user; empty where it is not.
  std::string whyBeside(const Pose& T_world_object) const;

  /// Why it does not contain the pose, in words for the user; empty where it does, or does but for
  /// rounding.
  std::string whyOutside(const Pose& T_world_object) const;
};

}  // namespace smore
