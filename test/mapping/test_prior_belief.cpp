// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "belief_observations.h"
#include "known_boxes.h"
#include "smore/mapping/joint_belief.h"
#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

// The wall that the bar of wallObservations is pushed against, with its front at `x`.
Prior wall(double x, double confidence = 0.999) {
  return boxKnown({x, -0.2, -0.1}, {x + 0.1, 0.2, 0.1}, 0.1, confidence);
}

double probabilityAt(const VoxelGrid& grid, const Vec3& place) {
  return grid.probability(voxelAt(place, grid.voxelSize())).value_or(0.0F);
}

TEST(PriorBelief, KnownMatterIsInTheMapsBeforeAnythingIsTouched) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, barKnown());
  belief.know(MapSide::kWorld, wall(0.5));
  EXPECT_GT(probabilityAt(belief.object(), {0.1, 0.0, 0.0}), 0.9);
  EXPECT_GT(probabilityAt(belief.world(), {0.54, 0.1, 0.0}), 0.9);
  EXPECT_LT(probabilityAt(belief.object(), {0.1, 0.1, 0.0}), 0.1);
  EXPECT_LT(probabilityAt(belief.world(), {0.4, 0.1, 0.0}), 0.1);
}

TEST(PriorBelief, ItsConfidenceIsTheShareOfTheWorldsThatHoldIt) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kWorld, wall(0.5, 0.7));
  EXPECT_NEAR(probabilityAt(belief.world(), {0.54, 0.1, 0.0}), 0.7, 0.2);  // 3.5 deviations of 64
}

TEST(PriorBelief, ATouchIsWhereTheKnownObjectIs) {
  // One push along x: by itself it could be anywhere on its line.
  const auto probabilityOfWall = [](bool is_known) {
    JointBelief belief(planarParameters());
    if (is_known) belief.know(MapSide::kObject, barKnown());
    belief.observe(freeAt(Pose::Identity(), 0.0));
    belief.observe(contactAt(makePose({0.3, 0.0, 0.0}), {0.2, 0.0, 0.0}, {-1, 0, 0}));
    return probabilityAt(belief.world(), {0.515, 0.0, 0.0});
  };
  EXPECT_LT(probabilityOfWall(false), 0.3);
  EXPECT_GT(probabilityOfWall(true), 0.5);
}

// Bar and wall overlapped at poses that were free. A shorter bar would do, or a farther wall.
TEST(PriorBelief, OfTwoPiecesThatContradictOneAnotherTheLessSureIsGivenUp) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, barKnown());
  belief.know(MapSide::kWorld, wall(0.42, 0.1));
  observeAll(wallObservations(), &belief);
  EXPECT_LT(probabilityAt(belief.world(), {0.43, 0.15, 0.0}), 0.2);
  EXPECT_GT(probabilityAt(belief.object(), {0.1, 0.0, 0.0}), 0.8);
}

TEST(PriorBelief, AWallThatIsThereIsKept) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, barKnown());
  belief.know(MapSide::kWorld, wall(0.5));
  observeAll(wallObservations(), &belief);
  EXPECT_GT(probabilityAt(belief.world(), {0.54, 0.15, 0.0}), 0.9);
  EXPECT_GT(probabilityAt(belief.object(), {0.1, 0.0, 0.0}), 0.9);
}

// The bar would have been in the wall at a pose that was free: one of the two is wrong.
TEST(PriorBelief, FreeSpaceAloneTellsThatTwoPiecesCannotBothBeTrue) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, barKnown());
  belief.know(MapSide::kWorld, boxKnown({-0.1, -0.2, -0.1}, {0.3, 0.2, 0.1}, 0.1));
  belief.observe(freeAt(Pose::Identity(), 0.0));
  const double object = probabilityAt(belief.object(), {0.1, 0.0, 0.0});
  const double world = probabilityAt(belief.world(), {0.2, 0.15, 0.0});
  EXPECT_NEAR(object + world, 1.0, 0.1);
}

// A slab across x, 4.5 cm thick and 30 cm wide, in voxels of 15 mm.
Prior slabKnown() {
  constexpr double kSize = 0.015;
  Prior prior{VoxelGrid(kSize), 0.999};
  visitVoxels(voxelAt({-0.1, -0.2, -0.2}, kSize), voxelAt({0.1, 0.2, 0.2}, kSize),
              [&](const VoxelKey& key) {
                const Vec3 center = voxelCenter(key, kSize);
                const bool is_matter = std::abs(center.x()) < 0.0225 &&
                                       std::abs(center.y()) < 0.15 && std::abs(center.z()) < 0.15;
                prior.known.set(key, is_matter ? 1.0F : 0.0F);
              });
  return prior;
}

JointBelief slabsKnown(double unit) {
  JointBeliefParameters parameters;
  parameters.unit = unit;
  JointBelief belief(parameters);
  belief.know(MapSide::kObject, slabKnown());
  belief.know(MapSide::kWorld, slabKnown());
  return belief;
}

// A wall on voxels of 5 cm, and a fence of two posts on voxels of 1 cm with an opening between.
TEST(PriorBelief, ACoarsePieceMakesNoFineOneCoarse) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, boxKnown({-0.02, -0.02, -0.1}, {0.02, 0.02, 0.1}, 0.1));
  belief.know(MapSide::kWorld, boxKnown({0.28, -0.3, -0.1}, {0.32, -0.06, 0.1}, 0.05));
  belief.know(MapSide::kWorld, boxKnown({0.28, 0.06, -0.1}, {0.32, 0.3, 0.1}, 0.05));
  const Eigen::Isometry3f opening = makePose({0.3, 0.0, 0.0}).cast<float>();
  EXPECT_LT(__builtin_popcountll(belief.worlds()->sampled.touching(opening)), 4);
  Prior coarse{VoxelGrid(0.1), 0.999};
  coarse.known.set(voxelAt({-1.0, 0.0, 0.0}, 0.1), 1.0F);
  belief.know(MapSide::kWorld, coarse);
  EXPECT_LT(__builtin_popcountll(belief.worlds()->sampled.touching(opening)), 4);
  EXPECT_EQ(belief.worlds()->sampled.parts().front().knownWorld().size(), 2U);
}

// A surface that was told in voxels may be half of one nearer, or farther.
TEST(PriorBelief, AGapBetweenKnownSurfacesIsFreeInAsManyWorldsAsItIsWideAgainstTheirVoxels) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, barKnown());
  belief.know(MapSide::kWorld, wall(0.5));
  const auto touchingAt = [&](double gap) {
    const Eigen::Isometry3f T = makePose({0.3 - gap, 0.0, 0.0}).cast<float>();
    return SampledWorlds::shareOf(belief.worlds()->sampled.touching(T));
  };
  EXPECT_LT(touchingAt(0.03), 0.05);
  EXPECT_NEAR(touchingAt(0.005), 0.35, 0.25);
  EXPECT_GT(touchingAt(-0.03), 0.95);
}

// However small the unit of length is against the voxels in which it is told.
TEST(PriorBelief, KnownMatterPassesNowhereThroughKnownMatter) {
  for (const double unit : {0.005, 0.02, 0.1}) {
    const JointBelief belief = slabsKnown(unit);
    for (const double y : {0.0, 0.0025, 0.005, 0.0075, 0.01}) {
      for (const double z : {0.0, 0.0035, 0.0075}) {
        const Eigen::Isometry3f T = makePose({0.0, y, z}).cast<float>();
        EXPECT_GT(__builtin_popcountll(belief.worlds()->sampled.touching(T)), 60)
            << "unit " << unit << ", beside one another by " << y << ", " << z;
      }
    }
  }
}

// The same slabs flat on one another, free at a pose: no contradiction, at any unit.
TEST(PriorBelief, KnownMatterThatSlidesAlongKnownMatterIsKept) {
  for (const double unit : {0.005, 0.02, 0.1}) {
    JointBelief belief = slabsKnown(unit);
    for (const double y : {0.0, 0.01, 0.02}) {
      belief.observe(freeAt(makePose({0.045, y, 0.0}), y));
    }
    EXPECT_GT(probabilityAt(belief.world(), Vec3::Zero()), 0.9) << unit;
    EXPECT_GT(probabilityAt(belief.object(), Vec3::Zero()), 0.9) << unit;
  }
}

TEST(PriorBelief, IsOverruledByMoreTouchesTheSurerItIs) {
  const auto touchesUntilGivenUp = [](double confidence) {
    JointBelief belief(planarParameters());
    belief.know(MapSide::kObject, barKnown());
    belief.know(MapSide::kWorld, boxKnown({1.5, -0.1, -0.1}, {1.6, 0.1, 0.1}, 1.9, confidence));
    int touches = 0;
    for (const ContactObservation& observation : wallObservations()) {
      belief.observe(observation);
      if (!observation.line) continue;
      ++touches;  // in space that is said to be free
      if (probabilityAt(belief.world(), {1.54, 0.0, 0.0}) < 0.5) return touches;
    }
    return touches + 1;
  };
  const int unsure = touchesUntilGivenUp(0.5);
  const int sure = touchesUntilGivenUp(0.999);
  EXPECT_LE(unsure, sure);
  EXPECT_LE(sure, 4);
}

TEST(PriorBelief, NeitherTheOrderNorARepetitionLeavesATrace) {
  JointBelief reference(planarParameters());
  reference.know(MapSide::kObject, barKnown());
  reference.know(MapSide::kWorld, wall(0.5));
  observeAll(wallObservations(), &reference);
  std::vector<ContactObservation> observations = wallObservations();
  std::shuffle(observations.begin(), observations.end(), std::mt19937(3));
  JointBelief belief(planarParameters());
  belief.know(MapSide::kWorld, wall(0.5));
  observeAll(observations, &belief);
  belief.know(MapSide::kObject, barKnown());
  belief.know(MapSide::kObject, barKnown());
  EXPECT_EQ(difference(reference.world(), belief.world()).first, 0.0);
  EXPECT_EQ(difference(reference.object(), belief.object()).first, 0.0);
}

// Seen points without free space: surfaces pull touches, and say nothing of what lies between.
TEST(PriorBelief, ACloudOfPointsPullsTouches) {
  Prior cloud{VoxelGrid(0.01), 0.999};
  for (double y = -0.2; y < 0.2; y += 0.01) cloud.known.set(voxelAt({0.501, y, 0.0}, 0.01), 1.0F);
  JointBelief belief(planarParameters());
  belief.know(MapSide::kWorld, cloud);
  belief.observe(freeAt(Pose::Identity(), 0.0));
  belief.observe(contactAt(makePose({0.3, 0.0, 0.0}), {0.2, 0.0, 0.0}, {-1, 0, 0}));
  EXPECT_GT(probabilityAt(belief.object(), {0.185, 0.0, 0.0}), 0.6);
}

// The object was free where the wall of that touch would go on. Such a touch claims no matter of
// its own, so that there is nothing to go on.
TEST(PriorBelief, ATouchOnAKnownSurfaceClaimsNoMatterBesideIt) {
  Prior cloud{VoxelGrid(0.01), 0.999};
  for (int i = -2; i <= 2; ++i) cloud.known.set(voxelAt({0.505, 0.01 * i, 0.0}, 0.01), 1.0F);
  JointBelief belief(planarParameters());
  belief.know(MapSide::kWorld, cloud);
  belief.observe(contactAt(makePose({0.3, 0.0, 0.0}), {0.2, 0.0, 0.0}, {-1, 0, 0}));
  for (int i = 10; i <= 62; ++i) belief.observe(freeAt(makePose({0.33, 0.01 * i, 0.0}), 0.0));
  for (const double y : {0.2, 0.3, 0.4}) {
    EXPECT_LT(probabilityAt(belief.world(), {0.515, y, 0.0}), 0.1) << y;
  }
}

TEST(PriorBelief, FreeSpaceThatChangesWhatIsKnownIsANewRevision) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, barKnown());
  belief.know(MapSide::kWorld, wall(0.5));
  const auto before = belief.revision();
  belief.observe(freeAt(makePose({0.4, 0.0, 0.0}), 0.0));
  EXPECT_GT(belief.revision(), before);
}

TEST(PriorBelief, TheUnitOfLengthIsThatOfAKnownObject) {
  JointBeliefParameters parameters = planarParameters();
  parameters.unit = 0.0;
  JointBelief small(parameters);
  small.know(MapSide::kObject, boxKnown({-0.01, -0.01, -0.1}, {0.03, 0.02, 0.1}, 0.02));
  JointBelief large(parameters);
  large.know(MapSide::kObject, boxKnown({-1.0, -0.8, -0.1}, {0.8, 0.9, 0.1}, 0.2));
  EXPECT_LT(small.worlds()->unit, 0.05);
  EXPECT_GT(large.worlds()->unit, 0.3);
}

TEST(PriorBelief, RefusesMorePiecesThanItCanTellApart) {
  JointBelief belief(planarParameters());
  for (int i = 0; i < kMostPriors; ++i) belief.know(MapSide::kWorld, wall(0.5, 0.5 + 0.005 * i));
  EXPECT_THROW(belief.know(MapSide::kWorld, wall(0.7)), std::runtime_error);
}

}  // namespace
}  // namespace smore
