// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/counter_random.h"
#include "smore/planning/risk_motion.h"
#include "smore/scenario/motion_space.h"

namespace smore {

/// The states of a motion space in the frame of a belief's map, and how to draw them.
class RiskSpace {
 public:
  /// `T_map_world`: the belief's frame. For planar motion its x-y plane must be that of the motion.
  /// `lever` [m]: what one radian counts.
  RiskSpace(const MotionSpace& space, const Pose& T_map_world, double lever);

  /// In planar motion the pose is projected onto the plane.
  RiskState toState(const Pose& T_world_object) const;
  Pose toPose(const RiskState& state) const;
  bool contains(const RiskState& state) const;
  /// Whether the object may have come there (MotionSpace::isNearWorkspace).
  bool isNearWorkspace(const RiskState& state) const {
    return space_.isNearWorkspace(toPose(state));
  }

  /// Uniform over the workspace and all rotations of the motion.
  RiskState sample(CounterRandom* random) const;

  /// Within `distance` [m] on each axis, with a turn of at most `angle` [rad].
  RiskState sampleNear(const RiskState& center, double distance, double angle,
                       CounterRandom* random) const;

  /// As sampleNear, but along one axis alone, or turning alone: what gets out of a narrow slot.
  RiskState sampleAlongAxis(const RiskState& center, double distance, double angle,
                            CounterRandom* random) const;

  bool planar() const { return space_.motion == Motion::kPlanar; }
  /// Whether turns have no end (MotionSpace); spatial ones have none.
  bool fullTurns() const { return !planar() || space_.full_turns; }
  double lever() const { return lever_; }

 private:
  Eigen::Quaternionf turn(double angle, CounterRandom* random) const;

  MotionSpace space_;
  Pose T_map_world_;
  double lever_;
};

}  // namespace smore
