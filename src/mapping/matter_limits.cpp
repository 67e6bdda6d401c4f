// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/matter_limits.h"

namespace smore {

float matterCell(const FeatureParameters& feature) {
  return static_cast<float>(feature.conflictDistance()) / 3.0F;
}

// By touched matter of the other side, and by what is known of it beforehand.
MatterLimits::MatterLimits(MapSide side, const std::vector<MaskedPoint>& other,
                           const FreeSpaceEvidence& evidence, const BelievedPrior& prior,
                           const FeatureParameters& feature, bool planar)
    : side_(side), reach_(static_cast<float>(feature.reach)), prior_(prior) {
  const bool on_object = side == MapSide::kObject;
  std::vector<Eigen::Isometry3f> poses = evidence.poses();
  if (on_object) {
    for (Eigen::Isometry3f& T : poses) T = T.inverse();
  }
  const auto distance = static_cast<float>(feature.conflictDistance());
  const float cell = matterCell(feature);
  forbidden_.emplace_back(other, poses, distance, cell, planar);
  for (const KnownBalls& known : prior.balls(on_object ? MapSide::kWorld : MapSide::kObject)) {
    forbidden_.emplace_back(known.balls, poses, known.overlapDistance(feature.radius), cell,
                            planar);
  }
}

HypothesisMask MatterLimits::forbiddenAt(const Eigen::Vector3f& point, HypothesisMask asked,
                                         Known known) const {
  if (side_ == MapSide::kObject && point.norm() > reach_) return asked;
  HypothesisMask result = known == Known::kMatterGoesOn ? prior_.knowingFree(side_, point)
                                                        : prior_.knowing(side_, point);
  for (const ForbiddenMatter& matter : forbidden_) {
    if ((asked & ~result) == 0) break;
    result |= matter.at(point);
  }
  return result & asked;
}

MatterAllowed MatterLimits::allowedFor(int hypothesis, Known known) const {
  const HypothesisMask bit = HypothesisMask{1} << hypothesis;
  return [this, known, bit](const Eigen::Vector3f& point) {
    return forbiddenAt(point, bit, known) == 0;
  };
}

}  // namespace smore
