// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "belief_observations.h"
#include "known_boxes.h"

namespace smore {
namespace {

// Of 128 places drawn at random, more than three standard deviations.
constexpr double kSampling = 0.14;

// A wall from x = 0.5 on, and 1.5 m of free space before it.
Prior wall(double confidence = 0.999) {
  return boxKnown({0.5, -1.0, -0.1}, {1.5, 1.0, 0.1}, 1.5, confidence);
}

double shareAt(const JointBelief& belief, double x) {
  return belief.worlds()->sampled.unknownShareAt(makePose({x, 0.0, 0.0}).cast<float>());
}

TEST(UnknownPlaces, AreAllWhereNothingIsKnown) {
  const JointBelief belief(planarParameters());
  EXPECT_EQ(shareAt(belief, 0.0), 1.0);
  JointBelief touched(planarParameters());
  observeAll(wallObservations(), &touched);
  EXPECT_EQ(shareAt(touched, 0.0), 1.0);
}

TEST(UnknownPlaces, AreNoneWhereBothSidesAreKnown) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, barKnown());
  belief.know(MapSide::kWorld, wall());
  EXPECT_EQ(shareAt(belief, 0.0), 0.0);
  EXPECT_EQ(shareAt(belief, 0.4), 0.0);  // the bar is in the wall: known, not unknown
}

// Something unknown may touch the object's matter alone: of the disc in which it lies.
TEST(UnknownPlaces, AreItsMatterWhereTheObjectIsKnown) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kObject, barKnown());
  const double share = 0.2 * 0.04 / (M_PI * 0.2 * 0.2);
  EXPECT_NEAR(shareAt(belief, 0.0), share, 0.08);
  EXPECT_GT(shareAt(belief, 0.0), 0.0);
  EXPECT_EQ(shareAt(belief, 3.0), shareAt(belief, 0.0));
}

// A part of the object of which no end is known may reach as far as anything that is held.
TEST(UnknownPlaces, ReachAsFarAsEverWhereAnyPartOfTheObjectMayGoOn) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kWorld, wall());
  belief.know(MapSide::kObject, barKnown());
  Prior cloud{VoxelGrid(0.01), 0.999};
  cloud.known.set(voxelAt({0.0, 0.1, 0.0}, 0.01), 1.0F);
  const double alone = shareAt(belief, 0.35);
  belief.know(MapSide::kObject, cloud);
  EXPECT_EQ(alone, 0.0);
  EXPECT_GT(shareAt(belief, 0.35), 0.1);
}

// Its matter counts also where no free space is known just beside it.
TEST(UnknownPlaces, ReachAsFarAsMatterOfWhichNoSurfaceIsKnown) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kWorld, wall());
  belief.know(MapSide::kObject, barKnown());
  Prior apart{VoxelGrid(0.01), 0.999};
  apart.known.set(voxelAt({0.0, 0.5, 0.0}, 0.01), 1.0F);
  apart.known.set(voxelAt({0.0, 0.6, 0.0}, 0.01), 0.0F);
  belief.know(MapSide::kObject, apart);
  EXPECT_GT(shareAt(belief, 0.2), 0.0);
}

// An unknown object may touch the wall alone: half of what lies within reach.
TEST(UnknownPlaces, AreTheMatterWithinReachWhereTheWorldIsKnown) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kWorld, wall());
  EXPECT_EQ(shareAt(belief, -0.15), 0.0);
  EXPECT_NEAR(shareAt(belief, 0.5), 0.5, kSampling);
  EXPECT_EQ(shareAt(belief, 9.0), 1.0);  // beyond what is known
}

TEST(UnknownPlaces, AreAllInWorldsThatDoNotHoldThePiecesToBeTrue) {
  JointBelief belief(planarParameters());
  belief.know(MapSide::kWorld, wall(0.6));
  EXPECT_NEAR(shareAt(belief, -0.15), 0.4, 0.22);  // 3.5 deviations of 64 worlds
}

}  // namespace
}  // namespace smore
