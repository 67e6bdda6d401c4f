// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/motion_space.h"

#include <cmath>
#include <sstream>

namespace smore {
namespace {

std::string describe(const Vec3& point) {
  std::ostringstream text;
  text << "(" << point.x() << " " << point.y() << " " << point.z() << ")";
  return text.str();
}

double yawOf(const Pose& pose) { return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)); }

}  // namespace

Pose MotionSpace::moved(const Pose& T_world_object) const {
  if (motion == Motion::kSpatial) return T_world_object;
  return T_world_plane * projectedToPlane(T_world_plane.inverse() * T_world_object);
}

// The shorter turn between two angles in (-pi, pi] that differ by more than pi leads past pi.
bool MotionSpace::allowsTurn(const Pose& T_world_from, const Pose& T_world_to) const {
  if (motion == Motion::kSpatial || full_turns) return true;
  const Pose T_plane_world = T_world_plane.inverse();
  return std::abs(yawOf(T_plane_world * T_world_from) - yawOf(T_plane_world * T_world_to)) <= M_PI;
}

bool MotionSpace::contains(const Pose& T_world_object) const {
  if (!workspace.contains(T_world_object.translation())) return false;
  if (motion == Motion::kSpatial) return true;
  constexpr double kTolerance = 1e-6;
  const Pose T_plane_object = T_world_plane.inverse() * T_world_object;
  const bool in_plane = std::abs(T_plane_object.translation().z()) <= kTolerance;
  const bool upright = (T_plane_object.linear().col(2) - Vec3::UnitZ()).norm() <= kTolerance;
  return in_plane && upright;
}

std::string MotionSpace::whyOutside(const Pose& T_world_object) const {
  if (contains(T_world_object)) return "";
  const Vec3 position = T_world_object.translation();
  if (workspace.contains(position)) {
    return describe(position) + " does not lie in the plane of motion";
  }
  return describe(position) + " is outside of the workspace " + describe(workspace.min) + " to " +
         describe(workspace.max);
}

}  // namespace smore
