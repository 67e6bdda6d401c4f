// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "smore/kinematics/arm_model.h"

namespace smore {

/// When to be at each configuration of a dense path, and how fast.
struct TimedConfiguration {
  double time = 0.0;  ///< since the start [s]
  JointVector position = JointVector::Zero();
  JointVector velocity = JointVector::Zero();
};

struct TimingLimits {
  JointVector velocity = JointVector::Ones();      ///< of each joint [rad/s], positive
  JointVector acceleration = JointVector::Ones();  ///< of each joint [rad/s^2], positive
};

/// The fastest timing of a kind along `path`, from rest to rest: each segment takes at least
/// `least_durations` [s] (one fewer than there are configurations) and no joint passes its limits.
///
/// The path's parameter counts its segments. Half of each joint's acceleration is kept for the
/// bends of the path, half for speeding up and slowing down along it: one pass from the end and one
/// from the start make the speed reachable. `path` has at least three configurations, neighbours
/// differ.
std::vector<TimedConfiguration> timeAlong(const std::vector<JointVector>& path,
                                          const std::vector<double>& least_durations,
                                          const TimingLimits& limits);

}  // namespace smore
