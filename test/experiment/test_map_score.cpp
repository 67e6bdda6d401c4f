// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <ctime>

#include "smore/experiment/map_score.h"
#include "smore/scenario/tessellation.h"

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
  const MapScore score = scoreMap(grid, box(), boundsOf(box()));
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
  const MapScore score = scoreMap(grid, box(), boundsOf(box()));
  EXPECT_EQ(score.occupied, 3);
  EXPECT_NEAR(*score.precision, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(*score.recall, 0.25, 1e-12);
}

TEST(ScoreMap, hasNoRatioWithNothingToDivideBy) {
  const MapScore nothing = scoreMap(VoxelGrid(0.1), box(), boundsOf(box()));
  EXPECT_FALSE(nothing.precision);
  EXPECT_EQ(nothing.recall, 0.0);
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 0.9F);
  const MapScore empty_world = scoreMap(grid, {}, {});
  EXPECT_EQ(empty_world.precision, 0.0);
  EXPECT_FALSE(empty_world.recall);
}

TEST(ScoreMap, recallIsThatOfTheRegion) {
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 0.9F);
  const Bounds corner{Vec3(-1.0, -1.0, -1.0), Vec3(0.09, 0.09, 1.0)};
  EXPECT_EQ(scoreMap(grid, box(), corner).recall, 1.0);
  EXPECT_FALSE(scoreMap(grid, box(), {Vec3(5, 5, 5), Vec3(6, 6, 6)}).recall);
}

// Every voxel of the region, one by one.
TEST(ScoreMap, recallCountsEachVoxelOfOverlappingSolidsOnce) {
  const std::vector<Shape> solids{
      {SphereShape{0.31}, makePose(Vec3(0.05, 0.1, 0.0))},
      {BoxShape{Vec3(0.9, 0.2, 0.15)}, makePose(Vec3(0.1, 0, 0), Vec3(0.3, 0.2, 0.7))},
      {CylinderShape{0.1, 1.0}, makePose(Vec3(-0.2, 0.3, 0), Vec3(1.0, 0.4, 0))}};
  const Bounds region{Vec3(-0.4, -0.3, -0.5), Vec3(0.5, 0.4, 0.3)};
  VoxelGrid grid(0.02);
  int inside = 0;
  int found = 0;
  const VoxelKey low = voxelAt(region.min, 0.02);
  const VoxelKey high = voxelAt(region.max, 0.02);
  for (VoxelKey key = low; key.x <= high.x; ++key.x) {
    for (key.y = low.y; key.y <= high.y; ++key.y) {
      for (key.z = low.z; key.z <= high.z; ++key.z) {
        if ((key.x + key.y + key.z) % 3 == 0) grid.set(key, 0.9F);
        if (signedDistance(solids, voxelCenter(key, 0.02)) > 0.0) continue;
        ++inside;
        found += (key.x + key.y + key.z) % 3 == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_NEAR(*scoreMap(grid, solids, region).recall, static_cast<double>(found) / inside, 1e-12);
}

// A floor of 100 m and a fine mesh cost no more than the voxels where they can be touched.
TEST(ScoreMap, isBoundedByTheRegionAndNotByTheSolids) {
  MeshShape ball = tessellate({SphereShape{0.3}, Pose::Identity()});
  const std::vector<Shape> solids{{BoxShape{Vec3(100, 100, 0.02)}, makePose(Vec3(0, 0, -0.5))},
                                  {ball, Pose::Identity()}};
  const Bounds region{Vec3(-1, -1, -1), Vec3(1, 1, 1)};
  const std::clock_t begin = std::clock();
  EXPECT_EQ(scoreMap(VoxelGrid(0.02), solids, region).recall, 0.0);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 10.0);
}

}  // namespace
}  // namespace smore
