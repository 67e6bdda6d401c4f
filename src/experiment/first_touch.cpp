// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/first_touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace smore {
namespace {

// A leg is compared with a pose at so many poses.
constexpr int kPosesOfLeg = 50;

double durationOf(const Path& path, const MotionSpeed& speed) {
  double duration = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) duration += speed.timeBetween(path[i - 1], path[i]);
  return duration;
}

}  // namespace

double MotionSpeed::timeBetween(const Pose& a, const Pose& b) const {
  return std::max(distanceBetween(a, b) / linear, angleBetween(a, b) / angular);
}

std::vector<Path> legsOf(const Path& path, const MotionSpeed& speed) {
  const double duration = durationOf(path, speed) / kLegs;
  if (!(duration > 0.0)) return {};
  std::vector<Path> legs = {{path.front()}};
  double left = duration;  // of the present leg
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double segment = speed.timeBetween(path[i - 1], path[i]);
    double at = left;
    for (; at < segment && legs.size() < kLegs; at += duration) {
      const Pose cut = interpolate(path[i - 1], path[i], at / segment);
      legs.back().push_back(cut);
      legs.push_back({cut});
    }
    left = at - segment;
    legs.back().push_back(path[i]);
  }
  return legs;
}

int legAt(const std::vector<Path>& legs, const Pose& pose, const MotionSpeed& speed) {
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const double step = durationOf(legs[leg], speed) / kPosesOfLeg;
    for (const Pose& along : densify(legs[leg], step * speed.linear, step * speed.angular)) {
      const double gap = speed.timeBetween(along, pose);
      if (gap >= least) continue;
      least = gap;
      nearest = static_cast<int>(leg);
    }
  }
  return nearest;
}

double logFirstTouch(const std::vector<double>& survival, const std::optional<int>& touched) {
  if (!touched) return std::log(survival.back());
  const double before = *touched == 0 ? 1.0 : survival[*touched - 1];
  return std::log(before - survival[*touched]);
}

double logUniformTouch(double risk, const std::optional<int>& touched) {
  return std::log(touched ? risk / kLegs : 1.0 - risk);
}

}  // namespace smore
