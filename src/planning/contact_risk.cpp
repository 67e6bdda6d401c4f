// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/contact_risk.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// Between two checks no matter moves farther than this share of the distance at which two balls
// touch, on each of the two ways to move it; it cannot pass through another unseen.
constexpr double kCheckShare = 0.3;
constexpr double kFinestCheck = 0.001;

}  // namespace

ContactRisk::ContactRisk(const JointBelief& belief)
    : belief_(&belief),
      worlds_(&belief.worlds()),
      check_distance_(std::max(kCheckShare * worlds_->contactDistance(), kFinestCheck)),
      check_angle_(check_distance_ / belief.parameters().feature.reach) {}

HypothesisMask ContactRisk::touching(const Pose& T_world_object) const {
  return worlds_->touching(belief_->toMap(T_world_object).cast<float>());
}

HypothesisMask ContactRisk::touchingAlong(const Path& path) const {
  HypothesisMask mask = 0;
  for (const Pose& pose : densify(path, check_distance_, check_angle_)) mask |= touching(pose);
  return mask;
}

double ContactRisk::ofMotion(const Path& path) const {
  const FreeSpaceEvidence& free = belief_->freeSpace();
  const double cell = free.parameters().position_cell;
  int unknown = 0;
  for (const Pose& pose : densify(path, cell, free.parameters().angle_cell)) {
    unknown += free.knows(belief_->toMap(pose)) ? 0 : 1;
  }
  const double contacts = 1.0 + static_cast<double>(belief_->contactCount());
  const double cells = kPriorLength / cell + static_cast<double>(free.cellCount());
  return 1.0 - (1.0 - along(path)) * std::exp(-contacts / cells * unknown);
}

}  // namespace smore
