// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "smore/mapping/voxel_runs.h"

namespace smore {
namespace {

constexpr std::int16_t kMin = std::numeric_limits<std::int16_t>::min();
constexpr std::int16_t kMax = std::numeric_limits<std::int16_t>::max();

TEST(VoxelRuns, standForRowsAlongX) {
  VoxelGrid grid(0.01);
  for (const int x : {5, 3, 4, -1}) grid.set({static_cast<std::int16_t>(x), 2, -7}, 1.0F);
  grid.set({6, 2, -7}, 0.0F);
  EXPECT_EQ(runsOf(grid, true), (std::vector<std::int32_t>{-1, 2, -7, 1, 3, 2, -7, 3}));
  EXPECT_EQ(runsOf(grid, false), (std::vector<std::int32_t>{6, 2, -7, 1}));
}

TEST(VoxelRuns, giveBackEveryVoxelToTheEndsOfTheRange) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> near(-3, 3);
  VoxelGrid grid(0.01);
  for (int i = 0; i < 300; ++i) {
    const auto index = [&] { return static_cast<std::int16_t>(near(random)); };
    grid.set({index(), index(), index()}, near(random) > 0 ? 1.0F : 0.0F);
  }
  grid.set({kMax, kMax, kMin}, 1.0F);
  grid.set({kMin, kMin, kMax}, 1.0F);
  VoxelGrid again(0.01);
  ASSERT_TRUE(setRuns(runsOf(grid, true), 1.0F, &again));
  ASSERT_TRUE(setRuns(runsOf(grid, false), 0.0F, &again));
  ASSERT_EQ(again.size(), grid.size());
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    EXPECT_EQ(again.probability(voxel.key), voxel.probability);
  }
}

TEST(VoxelRuns, areRefusedWhereTheyAreNone) {
  const std::int32_t far = std::numeric_limits<std::int32_t>::max();
  const std::vector<std::vector<std::int32_t>> damaged = {
      {1, 2, 3},           {0, 0, 0, 0},        {0, 0, 0, -1},       {kMax, 0, 0, 2},
      {kMin - 1, 0, 0, 1}, {0, kMax + 1, 0, 1}, {0, 0, kMin - 1, 1}, {far, 0, 0, far}};
  for (const auto& runs : damaged) {
    VoxelGrid grid(0.01);
    EXPECT_FALSE(setRuns(runs, 1.0F, &grid)) << runs.front();
  }
}

}  // namespace
}  // namespace smore
