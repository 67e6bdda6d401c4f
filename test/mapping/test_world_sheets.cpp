// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "at_a_decimetre.h"
#include "contact_at.h"
#include "smore/mapping/surface_extents.h"

namespace smore {
namespace {

// Of one contact that touched the world from above at the origin, where the ball below lies.
ContactHypotheses contactFromAbove() {
  ContactHypotheses contact = contactAt({0.0, 0.0, 0.1}, Vec3::Zero(), 1);
  contact.world_normal.set(0, Vec3::UnitZ());
  contact.object_normal.set(0, Vec3::UnitZ());
  return contact;
}

SheetsByHypothesis sheetsOf(const std::vector<ContactHypotheses>& contacts,
                            const FreeSpaceEvidence& evidence, bool planar = false) {
  const JointBeliefParameters lengths = atADecimetre();
  const std::vector<Explanation> explanations(kHypotheses, Explanation(contacts.size(), 0));
  SurfaceExtents surfaces({contacts, evidence, explanations, ~HypothesisMask{0}, {}},
                          lengths.feature, lengths.extent, planar, 1);
  return surfaces.takeWorldSheets().all();
}

FreeSpaceEvidence noEvidence() {
  const JointBeliefParameters lengths = atADecimetre();
  return FreeSpaceEvidence(lengths.free_space, lengths.feature.conflictDistance());
}

int worldsWith(const SheetsByHypothesis& sheets, const Eigen::Vector3f& offset) {
  return static_cast<int>(std::count_if(sheets.begin(), sheets.end(), [&](const auto& of_world) {
    return of_world.size() == 1 && of_world[0].reaches(offset);
  }));
}

TEST(WorldSheets, BeginAtTheTouchedSurface) {
  const auto radius = static_cast<float>(atADecimetre().feature.radius);
  for (const std::vector<SurfaceSheet>& of_world : sheetsOf({contactFromAbove()}, noEvidence())) {
    ASSERT_EQ(of_world.size(), 1U);
    EXPECT_LT((of_world[0].touched - Eigen::Vector3f(0.0F, 0.0F, radius)).norm(), 1e-6F);
    EXPECT_LT((of_world[0].normal - Eigen::Vector3f::UnitZ()).norm(), 1e-6F);
  }
}

// Twice as far as the patches in which touches are looked up.
TEST(WorldSheets, HaveRadiiOfAllOrdersOfMagnitudeAlike) {
  const ExtentParameters extent = atADecimetre().extent;
  const SheetsByHypothesis sheets = sheetsOf({contactFromAbove()}, noEvidence());
  const double longest = 2.0 * extent.world_longest;
  for (const double beside : {0.05, 0.1, 0.2, 0.4, 0.8}) {
    const double larger = std::log(longest / beside) / std::log(longest / extent.shortest);
    // The rim is ragged by a cell's width.
    EXPECT_NEAR(worldsWith(sheets, {static_cast<float>(beside), 0.0F, 0.0F}), 64.0 * larger, 6.0)
        << beside;
  }
  EXPECT_EQ(worldsWith(sheets, {static_cast<float>(1.01 * longest), 0.0F, 0.0F}), 0);
}

TEST(WorldSheets, AreThinInSomeWorldsAndAsThickAsTheBallsInOthersWhateverTheirRadius) {
  const double deepest = 2.0 * atADecimetre().feature.radius;
  const SheetsByHypothesis sheets = sheetsOf({contactFromAbove()}, noEvidence());
  for (const double depth : {0.08 * deepest, 0.2 * deepest, 0.5 * deepest}) {
    int thicker = 0;
    int thicker_and_large = 0;  // of the half that goes on the farthest
    for (int m = 0; m < kHypotheses; ++m) {
      if (sheets[m].at(0).thickness <= depth) continue;
      ++thicker;
      if (m >= kHypotheses / 2) ++thicker_and_large;
    }
    EXPECT_NEAR(thicker, 64.0 * std::log(deepest / depth) / std::log(25.0), 1.0) << depth;
    EXPECT_NEAR(thicker_and_large, 0.5 * thicker, 0.1 * thicker + 1.0) << depth;
  }
}

TEST(WorldSheets, EndWhereTheObjectWasFree) {
  const double distance = atADecimetre().feature.conflictDistance();
  FreeSpaceEvidence evidence = noEvidence();
  const Eigen::Vector3f there(0.3F, 0.0F, 0.0F);
  EXPECT_GT(worldsWith(sheetsOf({contactFromAbove()}, evidence), there), 10);
  // The object's ball, 0.1 m above its origin, lies beside the touch in the touched plane.
  for (double y = -1.5; y <= 1.5; y += 0.5 * distance) {
    evidence.addPose(makePose({0.2, y, -0.1}));
  }
  const SheetsByHypothesis sheets = sheetsOf({contactFromAbove()}, evidence);
  EXPECT_EQ(worldsWith(sheets, there), 0);
  EXPECT_GT(worldsWith(sheets, Eigen::Vector3f(-there)), 10) << "on the other side it goes on";
}

TEST(WorldSheets, InPlanarMotionThereAreNone) {
  for (const auto& of_world : sheetsOf({contactFromAbove()}, noEvidence(), true)) {
    EXPECT_TRUE(of_world.empty());
  }
}

}  // namespace
}  // namespace smore
