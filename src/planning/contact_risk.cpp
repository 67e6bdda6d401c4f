// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/contact_risk.h"

#include <algorithm>

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

}  // namespace smore
