// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/joint_trajectory.h"

#include <algorithm>

namespace smore {
namespace {

JointTrajectoryPoint atRest(const JointTrajectoryPoint& point, double time) {
  return {time, point.positions, std::vector<double>(point.positions.size(), 0.0)};
}

// Without velocities at both ends the way between two points is straight.
JointTrajectoryPoint between(const JointTrajectoryPoint& from, const JointTrajectoryPoint& to,
                             double time) {
  JointTrajectoryPoint state{time, from.positions, from.positions};
  const double h = to.time - from.time;
  const double s = (time - from.time) / h;
  const bool straight = from.velocities.empty() || to.velocities.empty();
  for (size_t i = 0; i < from.positions.size(); ++i) {
    const double way = to.positions[i] - from.positions[i];
    const double first = straight ? way : h * from.velocities[i];
    const double last = straight ? way : h * to.velocities[i];
    const double square = 3.0 * way - 2.0 * first - last;
    const double cube = first + last - 2.0 * way;
    state.positions[i] = from.positions[i] + s * (first + s * (square + s * cube));
    state.velocities[i] = (first + s * (2.0 * square + 3.0 * s * cube)) / h;
  }
  return state;
}

}  // namespace

JointTrajectoryPoint stateAt(const std::vector<JointTrajectoryPoint>& points, double time) {
  if (time < points.front().time) return atRest(points.front(), time);
  if (time >= points.back().time) return atRest(points.back(), time);
  const auto to = std::upper_bound(
      points.begin(), points.end(), time,
      [](double value, const JointTrajectoryPoint& point) { return value < point.time; });
  return between(*(to - 1), *to, time);
}

}  // namespace smore
