// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/motion_horizon.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// Points of a horizon lie at least this far apart [s]: a segment between two nearer ones says
// nothing that rounding does not.
constexpr double kLeastSpacing = 1e-3;
// The shortest brake [s]: where it begins is known late, so that a robot that moves is ahead of it
// and comes back. In less time what it holds would be jerked, and the jerk felt as a blow.
constexpr double kShortestBrake = 0.04;

double greatestSpeed(const std::vector<double>& velocities) {
  double greatest = 0.0;
  for (const double velocity : velocities) greatest = std::max(greatest, std::abs(velocity));
  return greatest;
}

// Rest after `state`, whose time and velocities are of a robot at full speed.
JointTrajectoryPoint restAfter(const JointTrajectoryPoint& state, double deceleration,
                               double scaling) {
  const double speed = scaling * greatestSpeed(state.velocities);
  const double duration = scaling * std::max(speed / deceleration, kShortestBrake);
  JointTrajectoryPoint rest = state;
  rest.time += duration;
  for (size_t i = 0; i < rest.positions.size(); ++i) {
    rest.positions[i] += 0.5 * duration * state.velocities[i];
    rest.velocities[i] = 0.0;
  }
  return rest;
}

JointTrajectoryPoint since(double time, JointTrajectoryPoint point) {
  point.time -= time;
  return point;
}

}  // namespace

JointTrajectory brake(const std::vector<std::string>& joint_names,
                      const JointTrajectoryPoint& state, double deceleration, double scaling) {
  const double share = std::max(scaling, kLeastScaling);
  JointTrajectoryPoint full{0.0, state.positions, state.velocities};
  for (double& velocity : full.velocities) velocity /= share;
  return {joint_names, {restAfter(full, deceleration, share)}};
}

JointTrajectory horizonOf(const JointTrajectory& motion, double time, double scaling,
                          const HorizonParameters& parameters) {
  const double motion_end = motion.points.back().time;
  const double end = std::min(time + scaling * parameters.duration, motion_end);
  const double first = std::min(time + scaling * parameters.blend, end);
  JointTrajectory horizon{motion.joint_names, {since(time, stateAt(motion.points, first))}};
  for (const JointTrajectoryPoint& point : motion.points) {
    const bool between = point.time > first + kLeastSpacing && point.time < end - kLeastSpacing;
    if (between) horizon.points.push_back(since(time, stateAt(motion.points, point.time)));
  }
  if (first < end) horizon.points.push_back(since(time, stateAt(motion.points, end)));
  if (end < motion_end) {
    const JointTrajectoryPoint last = horizon.points.back();
    horizon.points.push_back(restAfter(last, parameters.deceleration, scaling));
  }
  return horizon;
}

}  // namespace smore
