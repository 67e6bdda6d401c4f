// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/common/geometry.h"

namespace smore {

/// The frame in which a belief infers: in space the world; in planar motion the frame of the plane,
/// onto which poses are projected, since an arm is never quite in it.
class MapFrame {
 public:
  /// `T_world_plane`: the plane of planar motion is its x-y plane; nothing for motion in space.
  explicit MapFrame(const std::optional<Pose>& T_world_plane)
      : planar_(T_world_plane.has_value()),
        T_map_world_(planar_ ? T_world_plane->inverse() : Pose::Identity()) {}

  bool planar() const { return planar_; }
  const Pose& T_map_world() const { return T_map_world_; }

  /// T_map_object.
  Pose toMap(const Pose& T_world_object) const {
    const Pose T_map_object = T_map_world_ * T_world_object;
    return planar_ ? projectedToPlane(T_map_object) : T_map_object;
  }

 private:
  bool planar_;
  Pose T_map_world_;
};

}  // namespace smore
