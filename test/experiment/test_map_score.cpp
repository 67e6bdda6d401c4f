// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/experiment/map_score.h"

namespace smore {
namespace {

// A box of 2 x 2 x 1 voxels with its corner in the origin.
std::vector<Shape> box() {
  return {{BoxShape{Vec3(0.2, 0.2, 0.1)}, makePose(Vec3(0.1, 0.1, 0.05))}};
}

TEST(ScoreMap, ofThePerfectMapIsOne) {
  VoxelGrid grid(0.1);
  for (std::int16_t x = 0; x < 2; ++x) {
    for (std::int16_t y = 0; y < 2; ++y) grid.set({x, y, 0}, 0.5F);
  }
  const MapScore score = scoreMap(grid, box());
  EXPECT_EQ(score.occupied, 4);
  EXPECT_EQ(score.precision, 1.0);
  EXPECT_EQ(score.recall, 1.0);
  for (const double distance : score.distances) EXPECT_NEAR(distance, 0.05, 1e-9);
}

TEST(ScoreMap, countsWithinOneVoxelAsPreciseAndBeyondNot) {
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 0.9F);
  grid.set({-1, 0, 0}, 0.9F);  // centre 0.05 m outside
  grid.set({-2, 0, 0}, 0.9F);  // centre 0.15 m outside
  grid.set({1, 1, 0}, 0.49F);  // not occupied
  const MapScore score = scoreMap(grid, box());
  EXPECT_EQ(score.occupied, 3);
  EXPECT_NEAR(*score.precision, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(*score.recall, 0.25, 1e-12);
}

TEST(ScoreMap, hasNoRatioWithNothingToDivideBy) {
  const MapScore nothing = scoreMap(VoxelGrid(0.1), box());
  EXPECT_FALSE(nothing.precision);
  EXPECT_EQ(nothing.recall, 0.0);
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 0.9F);
  const MapScore empty_world = scoreMap(grid, {});
  EXPECT_EQ(empty_world.precision, 0.0);
  EXPECT_FALSE(empty_world.recall);
}

}  // namespace
}  // namespace smore
