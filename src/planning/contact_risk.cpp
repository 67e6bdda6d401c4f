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

// Probability that one more world would touch: with Jeffreys' prior for a share, none in 64 worlds
// is not yet never.
double predictedShare(double share) { return (kHypotheses * share + 0.5) / (kHypotheses + 1.0); }

double entropyTerm(double probability) {
  return probability > 0.0 ? -probability * std::log(probability) : 0.0;
}

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
  const FreeSpaceParameters& cell = free.parameters();
  int fresh = 0;
  for (const Pose& pose : densify(path, cell.position_cell, cell.angle_cell)) {
    fresh += free.knows(belief_->toMap(pose)) ? 0 : 1;
  }
  const double known = std::max(1.0, static_cast<double>(free.cellCount()));
  const double no_surprise = known / (known + fresh);
  return 1.0 - (1.0 - predictedShare(along(path))) * no_surprise;
}

double ContactRisk::surpriseRate() const {
  const FreeSpaceEvidence& free = belief_->freeSpace();
  const double contacts = 1.0 + static_cast<double>(belief_->contactCount());
  const double cells =
      kPriorLength / free.parameters().position_cell + static_cast<double>(free.cellCount());
  return contacts / cells;
}

double ContactRisk::informationOf(const Path& path) const {
  const FreeSpaceEvidence& free = belief_->freeSpace();
  const FreeSpaceParameters& cell = free.parameters();
  const double no_surprise_in_cell = std::exp(-surpriseRate());
  HypothesisMask touched = 0;
  double no_surprise = 1.0;
  double surprise = 0.0;
  double entropy = 0.0;
  for (const Pose& pose : densify(path, cell.position_cell, cell.angle_cell)) {
    const HypothesisMask first = touching(pose) & ~touched;
    touched |= first;
    entropy += entropyTerm(no_surprise * worlds_->shareOf(first));
    if (free.knows(belief_->toMap(pose))) continue;
    const double before = no_surprise;
    no_surprise *= no_surprise_in_cell;
    surprise += worlds_->shareOf(~touched) * (before - no_surprise);
  }
  const double patches = std::max(1.0, patchesOfObject());
  entropy += entropyTerm(surprise) + surprise * std::log(patches);
  return entropy + entropyTerm(no_surprise * worlds_->shareOf(~touched));
}

double ContactRisk::patchesOfObject() const {
  const double size = belief_->parameters().feature.reach / worlds_->contactDistance();
  return belief_->parameters().T_world_plane ? 2.0 * M_PI * size : 4.0 * M_PI * size * size;
}

}  // namespace smore
