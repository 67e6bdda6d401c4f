// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <octomap/octomap.h>

#include <memory>
#include <random>
#include <sstream>
#include <stdexcept>

#include "../scenario/temporary_directory.h"
#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

VoxelGrid randomGrid(int count) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> coordinate(-15, 15);
  std::uniform_real_distribution<float> probability(0.005F, 0.995F);
  VoxelGrid grid(0.03);
  for (int i = 0; i < count; ++i) {
    grid.set({static_cast<std::int16_t>(coordinate(random)),
              static_cast<std::int16_t>(coordinate(random)),
              static_cast<std::int16_t>(coordinate(random))},
             probability(random));
  }
  return grid;
}

void expectSame(const VoxelGrid& actual, const VoxelGrid& expected) {
  EXPECT_EQ(actual.size(), expected.size());
  for (const VoxelGrid::Voxel& voxel : expected.voxels()) {
    ASSERT_TRUE(actual.probability(voxel.key));
    EXPECT_NEAR(*actual.probability(voxel.key), voxel.probability, 1e-6);
  }
}

TEST(ToOctree, keepsEachProbabilityThroughAFile) {
  const VoxelGrid grid = randomGrid(3000);
  std::stringstream file;
  ASSERT_TRUE(toOctree(grid)->write(file));
  const std::unique_ptr<octomap::AbstractOcTree> read(octomap::AbstractOcTree::read(file));
  const auto* tree = dynamic_cast<octomap::OcTree*>(read.get());
  ASSERT_NE(tree, nullptr);
  expectSame(fromOctree(*tree), grid);
}

TEST(ToOctree, findsAVoxelByItsCentre) {
  const VoxelGrid grid = randomGrid(500);
  const auto tree = toOctree(grid);
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    const Vec3 center = voxelCenter(voxel.key, grid.voxelSize());
    const auto* node = tree->search(center.x(), center.y(), center.z());
    ASSERT_NE(node, nullptr);
    EXPECT_NEAR(node->getOccupancy(), voxel.probability, 1e-6);
  }
}

TEST(ToOctree, countsExactlyOneHalfAsOccupied) {
  VoxelGrid grid(0.03);
  grid.set({1, 2, 3}, 0.5F);
  grid.set({2, 2, 3}, 0.4999F);
  const auto tree = toOctree(grid);
  EXPECT_TRUE(tree->isNodeOccupied(tree->search(0.045, 0.075, 0.105)));
  EXPECT_FALSE(tree->isNodeOccupied(tree->search(0.075, 0.075, 0.105)));
}

TEST(ToOctree, keepsEightEqualSiblingsAsVoxels) {
  VoxelGrid grid(0.03);
  for (std::int16_t i = 0; i < 8; ++i) {
    grid.set({static_cast<std::int16_t>(i & 1), static_cast<std::int16_t>((i >> 1) & 1),
              static_cast<std::int16_t>(i >> 2)},
             0.9F);
  }
  const auto tree = toOctree(grid);
  expectSame(fromOctree(*tree), grid);
  tree->prune();
  EXPECT_EQ(tree->getNumLeafNodes(), 1u);
  expectSame(fromOctree(*tree), grid);
}

TEST(ToOctree, ofAnEmptyGridIsEmpty) { EXPECT_EQ(toOctree(VoxelGrid(0.03))->size(), 0u); }

TEST(ToOctree, isWrittenWholeOrNotAtAll) {
  TemporaryDirectory directory;
  VoxelGrid grid(0.03);
  grid.set({1, 2, 3}, 0.9F);
  const auto tree = toOctree(grid);
  const std::string file = directory.path() + "/map.ot";
  writeOctree(*tree, file);
  EXPECT_EQ(std::unique_ptr<octomap::AbstractOcTree>(octomap::AbstractOcTree::read(file))->size(),
            tree->size());
  EXPECT_THROW(writeOctree(*tree, directory.path() + "/gone/map.ot"), std::runtime_error);
}

}  // namespace
}  // namespace smore
