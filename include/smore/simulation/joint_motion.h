// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/joint_trajectory.h"

namespace smore {

/// Joint positions and velocities that follow a trajectory in time, as a joint trajectory
/// controller does: cubic between points with velocities, straight where a point has none.
class JointMotion {
 public:
  /// At rest at `positions`, in the order of `names`.
  JointMotion(const std::vector<std::string>& names, const std::vector<double>& positions);

  /// Replaces the motion: from where the one before has come to, as fast as it is there, to the
  /// first point; at that at once where its time is 0. InputError for no points, unknown, missing
  /// or repeated joints, points of a wrong size, values that are not finite or times that do not
  /// rise.
  void follow(const JointTrajectory& trajectory);

  /// Ends the motion at `now`, at rest.
  void stop(const std::vector<double>& now);

  /// Whether the end of the trajectory has not been reached.
  bool moving() const { return time_ < end_; }

  /// Moves on by `step` [s], not negative.
  void advance(double step);

  const std::vector<double>& positions() const { return positions_; }
  const std::vector<double>& velocities() const { return velocities_; }

 private:
  std::vector<JointTrajectoryPoint> ordered(const JointTrajectory& trajectory) const;

  std::vector<std::string> names_;
  std::vector<JointTrajectoryPoint> points_;  ///< in the order of the names
  double time_ = 0.0;                         ///< since the trajectory's start [s]
  double end_ = 0.0;
  std::vector<double> positions_;
  std::vector<double> velocities_;
};

}  // namespace smore
