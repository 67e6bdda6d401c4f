// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/blocked_movements.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace smore {
namespace {

// Where a kernel ends, in widths: it is one per cent there.
constexpr double kReach = 3.0;

// Configurations nearer than this are one, in widths: between two of them a kernel is 0.97.
constexpr double kSpacing = 0.5;

BlockedMovementsParameters checked(const BlockedMovementsParameters& parameters) {
  const bool sound = parameters.width > 0.0 && parameters.prior > 0.0 && parameters.prior < 1.0 &&
                     parameters.weight > 0.0;
  if (!sound) throw std::invalid_argument("a parameter of the blocked movements is out of range");
  return parameters;
}

}  // namespace

BlockedMovements::BlockedMovements(const BlockedMovementsParameters& parameters)
    : parameters_(checked(parameters)),
      free_(kReach * parameters.width),
      blocked_(kReach * parameters.width),
      trail_(parameters.width, 1.0) {}

void BlockedMovements::observe(const ContactObservation& observation) {
  const Pose& pose = observation.T_world_object;
  if (observation.state == ContactState::kFree) {
    trail_.record(pose);
    if (!counted(free_, pose)) free_.add(pose);
  } else if (contacts_.isFirst(observation)) {
    countBlocked(trail_.beyond(pose));
  }
}

std::optional<std::uint32_t> BlockedMovements::counted(const PoseIndex& index,
                                                       const Pose& T_world_object) const {
  std::optional<std::uint32_t> found;
  index.anyNear(T_world_object, [&](std::uint32_t position, double distance) {
    if (distance < kSpacing * parameters_.width) found = position;
    return found.has_value();
  });
  return found;
}

void BlockedMovements::countBlocked(const Pose& T_world_object) {
  if (const auto known = counted(blocked_, T_world_object)) {
    times_blocked_[*known] += 1.0;
    return;
  }
  blocked_.add(T_world_object);
  times_blocked_.push_back(1.0);
}

double BlockedMovements::blocked(const Pose& T_world_object) const {
  double failures = 0.0;
  blocked_.anyNear(T_world_object, [&](std::uint32_t position, double distance) {
    failures = std::max(failures, times_blocked_[position] * kernel(distance));
    return false;
  });
  double successes = 0.0;
  free_.anyNear(T_world_object, [&](std::uint32_t /*position*/, double distance) {
    successes = std::max(successes, kernel(distance));
    return false;
  });
  return (parameters_.weight * parameters_.prior + failures) /
         (parameters_.weight + failures + successes);
}

double BlockedMovements::kernel(double distance) const {
  const double widths = distance / parameters_.width;
  return widths < kReach ? std::exp(-0.5 * widths * widths) : 0.0;
}

double BlockedMovements::success(const Path& path) const {
  const double spacing = kSpacing * parameters_.width;
  const Path configurations = densify(path, spacing, spacing);
  double product = 1.0;
  for (std::size_t i = 1; i < configurations.size(); ++i) {
    const double moved = gapBetween(configurations[i - 1], configurations[i]);
    product *= std::pow(1.0 - blocked(configurations[i]), moved / parameters_.width);
  }
  return product;
}

}  // namespace smore
