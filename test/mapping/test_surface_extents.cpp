// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "at_a_decimetre.h"
#include "contact_at.h"
#include "smore/mapping/surface_extents.h"

namespace smore {
namespace {

// Two touches of the object 30 cm apart; what a third touched in the world lay at `obstacle` when
// the object was free. Whether matter joins the two.
bool joinsPastAnObstacleAt(const Vec3& obstacle) {
  const JointBeliefParameters lengths = atADecimetre();
  const FeatureParameters& feature = lengths.feature;
  FreeSpaceEvidence evidence(lengths.free_space, feature.conflictDistance());
  evidence.addPose(Pose::Identity());
  const Vec3 left(-0.15, 0.0, 0.03);
  const Vec3 right(0.15, 0.0, 0.03);
  const Vec3 far(2.0, 2.0, 2.0);
  const std::vector<ContactHypotheses> contacts = {
      contactAt(left, far, 1), contactAt(right, far, 2), contactAt(left, obstacle, 3)};
  const std::vector<Explanation> explanations(kHypotheses, Explanation(contacts.size(), 0));
  const BelievedPrior nothing_known;
  const SurfaceExtents surfaces(
      {contacts, evidence, explanations, ~HypothesisMask{0}, nothing_known}, feature,
      lengths.extent, false, 1);
  return std::any_of(surfaces.object().begin(), surfaces.object().end(),
                     [](const MaskedPoint& ball) { return std::abs(ball.point.x()) < 0.1F; });
}

TEST(SurfaceExtents, JoinTouchesInSpaceUnlessFreeSpaceSpeaksAgainstIt) {
  const double distance = atADecimetre().feature.conflictDistance();
  EXPECT_FALSE(joinsPastAnObstacleAt({0.0, 0.0, 0.03}));
  EXPECT_FALSE(joinsPastAnObstacleAt({0.0, 0.5 * distance, 0.03})) << "beside all touches";
  EXPECT_FALSE(joinsPastAnObstacleAt({0.0, 0.0, 0.03 - 0.5 * distance})) << "below all touches";
  EXPECT_TRUE(joinsPastAnObstacleAt({0.0, 2.0 * distance, 0.03}));
}

}  // namespace
}  // namespace smore
