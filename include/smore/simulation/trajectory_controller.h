// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/joint_trajectory.h"

namespace smore {

/// What a joint trajectory controller of ros_controllers does with the commands on its topic, in
/// the variant of Universal Robots' driver: its clock runs at the share of full speed that the
/// robot's slider sets. Velocities are those of a robot at full speed.
///
/// - A trajectory takes the place of the one before at once: the controller passes from the state
///   that it is in to the first point, cubic or, without velocities, straight. Points at time 0 or
///   before are skipped without a word. It stays at the last point.
/// - A trajectory without points is no command to hold: with a stop duration T it runs on along a
///   quintic to rest, whose way is 0.625 T times the velocity; each stop begins the ramp anew. With
///   T = 0 it holds at once.
/// - A controller that is not running drops commands without a word.
class TrajectoryController {
 public:
  /// At rest at `positions`, in the order of `names`; `stop_duration` [s of its own clock], 0 or
  /// more.
  TrajectoryController(std::vector<std::string> names, const std::vector<double>& positions,
                       double stop_duration);

  /// A command; its joints in any order. One that is not of all joints, or not of numbers, is
  /// dropped.
  void command(const JointTrajectory& trajectory);

  /// Starts it at `positions`, at rest, with nothing to do.
  void start(const std::vector<double>& positions);
  void stop() { running_ = false; }
  bool running() const { return running_; }

  /// Moves on by `step` [s of wall time] at the share `scaling` of full speed, in [0, 1].
  void advance(double step, double scaling);

  const std::vector<double>& positions() const { return state_.positions; }
  const std::vector<double>& velocities() const { return state_.velocities; }

 private:
  void rampDown();
  JointTrajectoryPoint onRamp(double time) const;

  std::vector<std::string> names_;
  double stop_duration_;
  bool running_ = true;
  JointTrajectoryPoint state_;
  std::vector<JointTrajectoryPoint> points_;  ///< since the last command; empty: the ramp, or rest
  JointTrajectoryPoint ramp_begin_;           ///< at rest where nothing ramps
  double time_ = 0.0;                         ///< since the last command, on its own clock [s]
};

}  // namespace smore
