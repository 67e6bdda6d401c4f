// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/joint_motion.h"

#include <algorithm>
#include <cmath>

#include "smore/common/result.h"

namespace smore {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw InputError("a joint trajectory was refused: " + problem);
}

// Position of each of `names` in the trajectory's order.
std::vector<size_t> orderOf(const std::vector<std::string>& names,
                            const std::vector<std::string>& given) {
  if (given.size() != names.size()) {
    refuse("it names " + std::to_string(given.size()) + " joints, the robot has " +
           std::to_string(names.size()));
  }
  std::vector<size_t> order;
  for (const std::string& name : names) {
    const auto found = std::find(given.begin(), given.end(), name);
    if (found == given.end()) refuse("the joint " + name + " is missing");
    order.push_back(static_cast<size_t>(found - given.begin()));
  }
  return order;
}

std::vector<double> reordered(const std::vector<double>& values, const std::vector<size_t>& order) {
  std::vector<double> result;
  for (const size_t index : order) {
    const double value = values[index];
    if (!std::isfinite(value)) refuse("a position or velocity is not finite");
    result.push_back(value);
  }
  return result;
}

}  // namespace

JointMotion::JointMotion(const std::vector<std::string>& names,
                         const std::vector<double>& positions)
    : names_(names), positions_(positions), velocities_(names.size(), 0.0) {}

std::vector<JointTrajectoryPoint> JointMotion::ordered(const JointTrajectory& trajectory) const {
  const std::vector<size_t> order = orderOf(names_, trajectory.joint_names);
  std::vector<JointTrajectoryPoint> points;
  for (const JointTrajectoryPoint& point : trajectory.points) {
    if (point.positions.size() != names_.size()) refuse("a point has not one position a joint");
    if (!point.velocities.empty() && point.velocities.size() != names_.size()) {
      refuse("a point has not one velocity a joint");
    }
    const double before = points.empty() ? -1.0 : points.back().time;
    if (!std::isfinite(point.time) || point.time < 0.0 || point.time <= before) {
      refuse("the times of its points do not rise from 0 on");
    }
    points.push_back({point.time, reordered(point.positions, order), {}});
    if (!point.velocities.empty()) points.back().velocities = reordered(point.velocities, order);
  }
  return points;
}

void JointMotion::follow(const JointTrajectory& trajectory) {
  if (trajectory.points.empty()) refuse("it has no points");
  std::vector<JointTrajectoryPoint> points = ordered(trajectory);
  if (points.front().time > 0.0) points.insert(points.begin(), {0.0, positions_, velocities_});
  points_ = std::move(points);
  time_ = 0.0;
  end_ = points_.back().time;
  advance(0.0);
}

void JointMotion::stop(const std::vector<double>& now) {
  time_ = end_ = 0.0;
  positions_ = now;
  velocities_.assign(now.size(), 0.0);
}

void JointMotion::advance(double step) {
  if (!moving()) return;
  time_ += step;
  const JointTrajectoryPoint state = stateAt(points_, time_);
  positions_ = state.positions;
  velocities_ = state.velocities;
}

}  // namespace smore
