// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace smore {

/// Where the joints are and how fast they move at one instant, in the order of the trajectory's
/// names.
struct JointTrajectoryPoint {
  double time = 0.0;               ///< since the start of the motion [s]
  std::vector<double> positions;   ///< [rad] or [m]
  std::vector<double> velocities;  ///< [rad/s] or [m/s]
};

/// A motion of joints through points at rising times, as trajectory_msgs/JointTrajectory carries
/// it; between two points positions follow the cubic polynomial that meets both positions and
/// velocities. No points: stay.
struct JointTrajectory {
  std::vector<std::string> joint_names;
  std::vector<JointTrajectoryPoint> points;
};

/// Where a motion is at `time` [s] since its start, with velocities: at rest at its first point
/// before that, at rest at its last from that on. `points`: at least one, at rising times.
JointTrajectoryPoint stateAt(const std::vector<JointTrajectoryPoint>& points, double time);

}  // namespace smore
