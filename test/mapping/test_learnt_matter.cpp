// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/mapping/learnt_matter.h"

namespace smore {
namespace {

constexpr int kMost = 64;

// A row of three voxels, two that touch over an edge, and one by itself.
VoxelGrid someMap() {
  VoxelGrid map(0.03);
  map.set({10, 0, 0}, 0.6F);
  map.set({0, 0, 0}, 0.9F);
  map.set({2, 0, 0}, 0.9F);
  map.set({1, 0, 0}, 0.75F);
  map.set({-5, 0, 0}, 0.5F);
  map.set({-6, 1, 0}, 0.7F);
  map.set({3, 0, 0}, 0.49F);  // rather not
  return map;
}

TEST(LearntMatter, isOnePieceForWhatHangsTogetherTheLargestFirst) {
  const std::vector<Prior> pieces = learntMatter(someMap(), {}, kMost);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].known.size(), 3U);
  EXPECT_NEAR(pieces[0].confidence, 0.85, 1e-6);
  EXPECT_TRUE(pieces[0].known.find({1, 0, 0}));
  EXPECT_FALSE(pieces[0].known.find({3, 0, 0}));
  EXPECT_EQ(pieces[1].known.size(), 2U);
  EXPECT_NEAR(pieces[1].confidence, 0.6, 1e-6);
  EXPECT_EQ(pieces[2].known.size(), 1U);
}

TEST(LearntMatter, isNeverBeyondDoubt) {
  VoxelGrid map(0.03);
  map.set({0, 0, 0}, 1.0F);
  EXPECT_LT(learntMatter(map, {}, kMost).at(0).confidence, 1.0);
}

TEST(LearntMatter, leavesOutWhatIsKnownToBeMatterOnAnotherLattice) {
  Prior known{VoxelGrid(0.0075), 0.999};
  for (std::int16_t x = 0; x < 12; ++x) known.known.set({x, 1, 1}, 1.0F);  // the row
  known.known.set({41, 1, 1}, 0.0F);  // known to be free: the touches said otherwise
  const std::vector<Prior> pieces = learntMatter(someMap(), {known}, kMost);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].known.size(), 2U);
  EXPECT_TRUE(pieces[1].known.find({10, 0, 0}));
}

TEST(LearntMatter, tellsNoMoreThanThereIsRoomFor) {
  const Prior known{VoxelGrid(0.01), 0.9};
  EXPECT_EQ(learntMatter(someMap(), {known}, 3).size(), 2U);
  EXPECT_EQ(learntMatter(someMap(), {known, known}, 2).size(), 0U);
  EXPECT_EQ(learntMatter(VoxelGrid(0.03), {}, kMost).size(), 0U);
}

}  // namespace
}  // namespace smore
