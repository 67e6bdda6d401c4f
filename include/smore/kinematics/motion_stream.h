// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/common/joint_trajectory.h"
#include "smore/kinematics/motion_horizon.h"

namespace smore {

/// Hands a motion to a robot in short horizons, so that a robot that is left alone comes to rest.
///
/// It knows how far the motion has come from the robot's own clock (the stamps of its joint states)
/// and from the share of full speed at which the robot runs: a robot that is slowed down or paused
/// takes longer, and a clock that stands still moves nothing.
class MotionStream {
 public:
  explicit MotionStream(const HorizonParameters& parameters) : parameters_(parameters) {}

  /// Begins a motion in the place of any other. `motion`: with points at rising times, the first at
  /// 0 where the robot is now, at rest at its end.
  void begin(const JointTrajectory& motion);

  /// Sends nothing more.
  void end() { motion_.points.clear(); }

  /// Whether the robot needs further horizons to get to the end.
  bool active() const { return !motion_.points.empty(); }

  /// The robot's clock shows `stamp` [s], its speed is the share `scaling` of the full one; the
  /// next horizon where one is due. To be called several times in 20 ms, only while active.
  std::optional<JointTrajectory> advance(double stamp, double scaling);

  /// Where the robot should be; only while active.
  JointTrajectoryPoint expected() const { return stateAt(motion_.points, time_); }

 private:
  HorizonParameters parameters_;
  JointTrajectory motion_;
  double time_ = 0.0;            ///< since the motion's start, of a robot at full speed [s]
  std::optional<double> stamp_;  ///< the newest of the robot's clock; none since the start
  double since_horizon_ = 0.0;   ///< since one was sent, by that clock [s]
};

}  // namespace smore
