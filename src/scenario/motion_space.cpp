// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/motion_space.h"

#include <cmath>

namespace smore {

bool MotionSpace::contains(const Pose& T_world_object) const {
  if (!workspace.contains(T_world_object.translation())) return false;
  if (motion == Motion::kSpatial) return true;
  constexpr double kTolerance = 1e-6;
  const Pose T_plane_object = T_world_plane.inverse() * T_world_object;
  const bool in_plane = std::abs(T_plane_object.translation().z()) <= kTolerance;
  const bool upright = (T_plane_object.linear().col(2) - Vec3::UnitZ()).norm() <= kTolerance;
  return in_plane && upright;
}

}  // namespace smore
