// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/trajectory_controller.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace smore {
namespace {

// The place of each of `names` among `given`; nothing where they are not the same names.
std::optional<std::vector<size_t>> placesOf(const std::vector<std::string>& names,
                                            const std::vector<std::string>& given) {
  std::vector<size_t> places;
  for (const std::string& name : names) {
    const auto place = std::find(given.begin(), given.end(), name);
    if (place == given.end()) return std::nullopt;
    places.push_back(static_cast<size_t>(place - given.begin()));
  }
  if (given.size() != names.size()) return std::nullopt;
  return places;
}

// The values at `places`; nothing where there are not as many values as places or one is not
// finite.
std::optional<std::vector<double>> pick(const std::vector<double>& values,
                                        const std::vector<size_t>& places) {
  if (values.size() != places.size()) return std::nullopt;
  std::vector<double> picked;
  for (const size_t place : places) {
    if (!std::isfinite(values[place])) return std::nullopt;
    picked.push_back(values[place]);
  }
  return picked;
}

}  // namespace

TrajectoryController::TrajectoryController(std::vector<std::string> names,
                                           const std::vector<double>& positions,
                                           double stop_duration)
    : names_(std::move(names)), stop_duration_(stop_duration) {
  start(positions);
}

void TrajectoryController::start(const std::vector<double>& positions) {
  running_ = true;
  state_ = {0.0, positions, std::vector<double>(positions.size(), 0.0)};
  rampDown();
}

void TrajectoryController::rampDown() {
  points_.clear();
  time_ = 0.0;
  ramp_begin_ = state_;
}

void TrajectoryController::command(const JointTrajectory& trajectory) {
  if (!running_) return;
  if (trajectory.points.empty()) return rampDown();
  const auto places = placesOf(names_, trajectory.joint_names);
  if (!places) return;
  std::vector<JointTrajectoryPoint> points{{0.0, state_.positions, state_.velocities}};
  for (const JointTrajectoryPoint& point : trajectory.points) {
    const auto positions = pick(point.positions, *places);
    const auto velocities =
        point.velocities.empty() ? std::vector<double>() : pick(point.velocities, *places);
    if (!positions || !velocities || !std::isfinite(point.time)) return;
    if (point.time <= points.back().time) continue;
    points.push_back({point.time, *positions, *velocities});
  }
  if (points.size() == 1) return;
  points_ = std::move(points);
  time_ = 0.0;
}

void TrajectoryController::advance(double step, double scaling) {
  if (!running_) return;
  time_ += scaling * step;
  state_ = points_.empty() ? onRamp(time_) : stateAt(points_, time_);
}

// From p at velocity v to p + w at rest, w = 0.625 T v: where the quintic that comes back to p with
// velocity -v after 2 T turns round. With s the share of T:
//   p + v T (s - 6 s^3 + 8 s^4 - 3 s^5) + w (10 s^3 - 15 s^4 + 6 s^5).
JointTrajectoryPoint TrajectoryController::onRamp(double time) const {
  constexpr double kWayShare = 0.625;
  const double T = stop_duration_;
  const double s = T > 0.0 ? std::min(time / T, 1.0) : 1.0;
  JointTrajectoryPoint state = ramp_begin_;
  for (size_t i = 0; i < state.positions.size(); ++i) {
    const double v = ramp_begin_.velocities[i];
    const double begin = s - s * s * s * (6.0 - s * (8.0 - 3.0 * s));
    const double end = s * s * s * (10.0 - s * (15.0 - 6.0 * s));
    state.positions[i] += v * T * (begin + kWayShare * end);
    const double begin_speed = 1.0 - s * s * (18.0 - s * (32.0 - 15.0 * s));
    const double end_speed = 30.0 * s * s * (1.0 - s) * (1.0 - s);
    state.velocities[i] = v * (begin_speed + kWayShare * end_speed);
  }
  return state;
}

}  // namespace smore
