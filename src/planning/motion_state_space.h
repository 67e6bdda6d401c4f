// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/StateSpace.h>

#include <cstdint>

#include "smore/scenario/motion_space.h"

namespace smore {

/// OMPL's view of a motion space: SE(2) in the plane of a planar one, else SE(3). The distance of
/// two states is that of the origins [m] plus the angle between them [rad].
class MotionStateSpace {
 public:
  /// Samples are drawn from `seed` alone.
  MotionStateSpace(const MotionSpace& space, std::uint64_t seed);

  const ompl::base::StateSpacePtr& ompl() const { return ompl_; }

  /// T_world_object.
  Pose toPose(const ompl::base::State* state) const;

  /// Planar: the pose's projection into the plane.
  void fromPose(const Pose& T_world_object, ompl::base::State* state) const;

 private:
  bool isPlanar() const { return space_.motion == Motion::kPlanar; }

  MotionSpace space_;
  ompl::base::StateSpacePtr ompl_;
};

}  // namespace smore
