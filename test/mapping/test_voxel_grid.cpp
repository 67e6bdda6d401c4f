// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>

#include "smore/mapping/voxel_grid.h"
#include "smore/mapping/voxel_pairing.h"

namespace smore {
namespace {

TEST(VoxelAt, putsFacesIntoTheVoxelAbove) {
  EXPECT_EQ(voxelAt(Vec3(0.0, 0.5, -0.5), 0.5), (VoxelKey{0, 1, -1}));
  EXPECT_EQ(voxelAt(Vec3(-1e-9, 0.499, -0.501), 0.5), (VoxelKey{-1, 0, -2}));
}

TEST(VoxelAt, isTheInverseOfTheCentre) {
  for (const VoxelKey key : {VoxelKey{0, 0, 0}, VoxelKey{-5, 7, 300}, VoxelKey{-32768, 32767, 1}}) {
    EXPECT_EQ(voxelAt(voxelCenter(key, 0.03), 0.03), key);
  }
}

TEST(VoxelAt, refusesPointsOutsideOfTheKeyRange) {
  EXPECT_THROW(voxelAt(Vec3(1e6, 0, 0), 0.01), std::out_of_range);
  EXPECT_THROW(voxelAt(Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), 0.01),
               std::out_of_range);
}

TEST(VoxelGrid, behavesAsAMap) {
  std::mt19937 random(8);
  std::uniform_int_distribution<int> coordinate(-20, 20);
  std::uniform_real_distribution<float> probability(0.0F, 1.0F);
  VoxelGrid grid(0.05);
  std::map<VoxelKey, float> oracle;
  for (int i = 0; i < 20000; ++i) {
    const VoxelKey key{static_cast<std::int16_t>(coordinate(random)),
                       static_cast<std::int16_t>(coordinate(random)),
                       static_cast<std::int16_t>(coordinate(random))};
    if (i % 3 == 0) {
      grid.set(key, oracle[key] = probability(random));
    } else {
      const auto found = oracle.find(key);
      EXPECT_EQ(grid.probability(key).has_value(), found != oracle.end());
      if (found != oracle.end()) {
        EXPECT_EQ(*grid.probability(key), found->second);
      }
    }
  }
  EXPECT_EQ(grid.size(), oracle.size());
}

TEST(VoxelGrid, knowsNoNeighboursBeyondItsKeys) {
  EXPECT_EQ(neighbourOf({1, 2, 3}, -1, 0, 1), (VoxelKey{0, 2, 4}));
  EXPECT_FALSE(neighbourOf({32767, 0, 0}, 1, 0, 0));
  EXPECT_FALSE(neighbourOf({0, 0, -32768}, 0, 0, -1));
  EXPECT_EQ(neighbourOf({32767, 0, -32768}, -1, 0, 1), (VoxelKey{32766, 0, -32767}));
}

TEST(VoxelGrid, refusesAVoxelSizeThatIsNotPositive) {
  EXPECT_THROW(VoxelGrid(0.0), std::invalid_argument);
  EXPECT_THROW(VoxelGrid(-0.1), std::invalid_argument);
  EXPECT_THROW(VoxelGrid(std::nan("")), std::invalid_argument);
}

TEST(PairVoxels, pairsEachVoxelAtMostOnceWithTheNearerOne) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  constexpr double kSize = 0.03;
  std::vector<VoxelKey> keys;
  for (std::int16_t i = -30; i < 30; ++i) keys.push_back({i, static_cast<std::int16_t>(i / 2), 0});
  for (int repeat = 0; repeat < 100; ++repeat) {
    const Pose pose = makePose(Vec3(0.011, -0.02, 0.005), Vec3(0, 0, angle(random)));
    const auto pairs = pairVoxels(keys, pose, kSize);
    std::map<VoxelKey, double> kept;
    for (const PairedVoxels& pair : pairs) {
      const Vec3 center = pose.inverse() * voxelCenter(pair.world, kSize);
      EXPECT_EQ(pair.object, voxelAt(center, kSize));
      const double distance = (center - voxelCenter(pair.object, kSize)).norm();
      EXPECT_TRUE(kept.emplace(pair.object, distance).second) << "a partner was given twice";
    }
    for (const VoxelKey& key : keys) {
      const Vec3 center = pose.inverse() * voxelCenter(key, kSize);
      const VoxelKey partner = voxelAt(center, kSize);
      EXPECT_GE((center - voxelCenter(partner, kSize)).norm(), kept.at(partner) - 1e-12);
    }
  }
}

}  // namespace
}  // namespace smore
