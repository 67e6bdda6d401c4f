// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/motion_space.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace smore {
namespace {

// Rounding of a tilted plane's coordinates; far below any tolerance of a robot [m].
constexpr double kRounding = 1e-9;

double yawOf(const Pose& pose) { return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)); }

bool inPlane(const MotionSpace& space, const Pose& T_world_object) {
  if (space.motion == Motion::kSpatial) return true;
  // A tenth of a millimetre and of a milliradian: what people type, and above what a robot repeats.
  constexpr double kTolerance = 1e-4;
  const Pose T_plane_object = space.T_world_plane.inverse() * T_world_object;
  const bool in_plane = std::abs(T_plane_object.translation().z()) <= kTolerance;
  const bool upright = (T_plane_object.linear().col(2) - Vec3::UnitZ()).norm() <= kTolerance;
  return in_plane && upright;
}

std::string besideThePlane(const MotionSpace& space, const Pose& T_world_object) {
  const Pose T_plane_object = space.T_world_plane.inverse() * T_world_object;
  const double tilt = std::acos(std::clamp(T_plane_object.linear()(2, 2), -1.0, 1.0));
  std::ostringstream text;
  text << std::abs(T_plane_object.translation().z()) << " m and " << tilt
       << " rad beside the plane of motion";
  return text.str();
}

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
  return workspace.contains(T_world_object.translation()) && inPlane(*this, T_world_object);
}

bool MotionSpace::inWorkspace(const Pose& T_world_object) const {
  return workspace.widened(kRounding).contains(T_world_object.translation());
}

bool MotionSpace::isNearWorkspace(const Pose& T_world_object) const {
  return workspace.widened(kNearDistance).contains(T_world_object.translation());
}

std::string MotionSpace::whyOutside(const Pose& T_world_object) const {
  const Vec3 position = T_world_object.translation();
  if (!inWorkspace(T_world_object)) {
    return describe(position) + " is outside of the workspace " + describe(workspace.min) + " to " +
           describe(workspace.max);
  }
  if (inPlane(*this, T_world_object)) return "";
  return describe(position) + " is " + besideThePlane(*this, T_world_object);
}

bool MotionSpace::isBeside(const Pose& T_world_object) const {
  return motion == Motion::kPlanar && !isNearPlane(T_world_plane.inverse() * T_world_object);
}

std::string MotionSpace::whyBeside(const Pose& T_world_object) const {
  if (!isBeside(T_world_object)) return "";
  return besideThePlane(*this, T_world_object);
}

}  // namespace smore
