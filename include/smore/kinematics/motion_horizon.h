// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/joint_trajectory.h"
#include "smore/common/speed_scaling.h"

namespace smore {

/// All times are of the clock on the wall, whatever the robot's speed slider says.
struct HorizonParameters {
  double duration = 0.12;  ///< how far ahead a motion is sent, until its brake begins [s]
  /// Within this the robot passes from what it does to a horizon that has just come [s]. Times to
  /// the robot that differ by a few milliseconds change its speed by a tenth then.
  double blend = 0.04;
  double deceleration = 15.0;  ///< of each joint, in a brake [rad/s^2] or [m/s^2], positive
};

/// Comes to rest from `positions` at `velocities` as joints at constant deceleration do: each on a
/// parabola over the time T that the fastest of them needs, its way half of T times its velocity.
///
/// `scaling`: share of their speed at which the robot runs commanded motions, in (0, 1]; times in a
/// trajectory are of a robot at full speed, positions and velocities here as they are. The
/// trajectory starts when it arrives. At rest: stay at `positions`.
JointTrajectory brake(const std::vector<std::string>& joint_names,
                      const JointTrajectoryPoint& state, double deceleration, double scaling);

/// The part of `motion` that follows `time` [s, since its start, of a robot at full speed], for a
/// robot that is there now, and a brake: a robot that gets nothing further comes to rest within
/// `duration` and its brake. The first point lies `blend` ahead: a joint trajectory controller
/// passes there from the state that it is in. The end of `motion`, where it is within `duration`,
/// needs no brake.
///
/// `motion`: with points at rising times, at rest at its end. `time` is before its end.
JointTrajectory horizonOf(const JointTrajectory& motion, double time, double scaling,
                          const HorizonParameters& parameters);

}  // namespace smore
