// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/trajectory_timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace smore {
namespace {

// Half of each joint's acceleration is for the bends of the path, half for speeding up and slowing
// down along it. The cubic between two points bends up to twice as hard as the points lie.
constexpr double kBendShare = 0.25;
constexpr double kAlongShare = 0.5;

// Smallest of limit over amount over the joints; infinite where nothing moves.
double ratio(const JointVector& limit, const JointVector& amount) {
  double least = std::numeric_limits<double>::infinity();
  for (int joint = 0; joint < kArmJoints; ++joint) {
    if (amount[joint] != 0.0) least = std::min(least, limit[joint] / std::abs(amount[joint]));
  }
  return least;
}

// Joint change per segment at a configuration, by central differences.
JointVector slope(const std::vector<JointVector>& path, size_t i) {
  if (i == 0) return path[1] - path[0];
  if (i + 1 == path.size()) return path[i] - path[i - 1];
  return 0.5 * (path[i + 1] - path[i - 1]);
}

double segmentSpeed(const std::vector<JointVector>& path, const std::vector<double>& durations,
                    const TimingLimits& limits, size_t segment) {
  const double by_joints = ratio(limits.velocity, path[segment + 1] - path[segment]);
  return std::min(by_joints, 1.0 / durations[segment]);
}

// Greatest speed [segments/s] at each configuration, by speeds and bends alone.
std::vector<double> speedBounds(const std::vector<JointVector>& path,
                                const std::vector<double>& durations, const TimingLimits& limits) {
  std::vector<double> bounds(path.size(), 0.0);
  for (size_t i = 1; i + 1 < path.size(); ++i) {
    const JointVector bend = path[i + 1] - 2.0 * path[i] + path[i - 1];
    bounds[i] = std::min({segmentSpeed(path, durations, limits, i - 1),
                          segmentSpeed(path, durations, limits, i),
                          std::sqrt(ratio(kBendShare * limits.acceleration, bend))});
  }
  return bounds;
}

// The speed after a segment from `speed`, by the acceleration that is left for it.
double reachable(double speed, const JointVector& change, const TimingLimits& limits) {
  return std::sqrt(speed * speed + 2.0 * ratio(kAlongShare * limits.acceleration, change));
}

// Greatest share of a joint's acceleration limit that the cubic between two points needs: it is
// linear in time, greatest at one of the ends.
double accelerationShare(const TimedConfiguration& from, const TimedConfiguration& to,
                         const TimingLimits& limits) {
  const double h = to.time - from.time;
  const JointVector mean = (to.position - from.position) / h;
  const JointVector first = (6.0 * mean - 4.0 * from.velocity - 2.0 * to.velocity) / h;
  const JointVector last = (4.0 * to.velocity + 2.0 * from.velocity - 6.0 * mean) / h;
  return std::max(1.0 / ratio(limits.acceleration, first), 1.0 / ratio(limits.acceleration, last));
}

// Where bends and changes of speed meet, cubics pass the limits by a little: the whole motion is
// slowed until none does.
void slowDown(const TimingLimits& limits, std::vector<TimedConfiguration>* timed) {
  double share = 1.0;
  for (size_t i = 0; i + 1 < timed->size(); ++i) {
    share = std::max(share, accelerationShare((*timed)[i], (*timed)[i + 1], limits));
  }
  for (TimedConfiguration& point : *timed) {
    point.time *= std::sqrt(share);
    point.velocity /= std::sqrt(share);
  }
}

}  // namespace

std::vector<TimedConfiguration> timeAlong(const std::vector<JointVector>& path,
                                          const std::vector<double>& least_durations,
                                          const TimingLimits& limits) {
  std::vector<double> speeds = speedBounds(path, least_durations, limits);
  for (size_t i = 1; i < path.size(); ++i) {
    speeds[i] = std::min(speeds[i], reachable(speeds[i - 1], path[i] - path[i - 1], limits));
  }
  for (size_t i = path.size() - 1; i > 0; --i) {
    speeds[i - 1] = std::min(speeds[i - 1], reachable(speeds[i], path[i] - path[i - 1], limits));
  }
  std::vector<TimedConfiguration> timed(path.size());
  for (size_t i = 0; i < path.size(); ++i) {
    timed[i].position = path[i];
    timed[i].velocity = speeds[i] * slope(path, i);
    if (i > 0) timed[i].time = timed[i - 1].time + 2.0 / (speeds[i - 1] + speeds[i]);
  }
  slowDown(limits, &timed);
  return timed;
}

}  // namespace smore
