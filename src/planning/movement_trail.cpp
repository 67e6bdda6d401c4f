// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/movement_trail.h"

#include <algorithm>
#include <stdexcept>

namespace smore {
namespace {

// Poses of the trail this share of a step apart tell its direction well enough.
constexpr double kSpacingShare = 0.1;

// A way to and fro within a step is kept no longer than this: ten times a straight one.
constexpr std::size_t kMostPoses = 100;

}  // namespace

MovementTrail::MovementTrail(double step, double lever) : step_(step), lever_(lever) {
  if (!(step > 0.0 && lever >= 0.0)) {
    throw std::invalid_argument("the step of a trail must be positive, its lever not negative");
  }
}

void MovementTrail::record(const Pose& T_world_object) {
  if (!poses_.empty()) {
    const double moved = lengthBetween(poses_.back(), T_world_object);
    if (moved < kSpacingShare * step_) return;
    if (moved > step_) poses_.clear();
  }
  poses_.push_back(T_world_object);
  while (poses_.size() > 1 && lengthBetween(poses_[1], T_world_object) >= step_) {
    poses_.pop_front();
  }
  if (poses_.size() > kMostPoses) poses_.pop_front();
}

Pose MovementTrail::beyond(const Pose& T_world_object) const {
  const auto from = std::find_if(poses_.rbegin(), poses_.rend(), [&](const Pose& pose) {
    return lengthBetween(pose, T_world_object) >= step_;
  });
  if (from == poses_.rend()) return T_world_object;
  Pose pose = Pose::Identity();
  pose.translation() = 2.0 * T_world_object.translation() - from->translation();
  pose.linear() = T_world_object.linear() * from->linear().transpose() * T_world_object.linear();
  return pose;
}

double MovementTrail::lengthBetween(const Pose& a, const Pose& b) const {
  return distanceBetween(a, b) + lever_ * angleBetween(a, b);
}

}  // namespace smore
