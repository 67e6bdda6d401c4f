// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <octomap/octomap.h>

#include <sstream>

#include "../scenario/temporary_directory.h"
#include "prior_scenes.h"

namespace smore {
namespace {

// Walls that are thinner than the lattice, as a mapping of finer voxels has them.
TEST(PriorOctrees, FinerOctreesKeepTheirWalls) {
  TemporaryDirectory directory;
  VoxelGrid grid(0.002);
  for (double y = -0.049; y < 0.05; y += 0.002) {
    grid.set(voxelAt({0.101, y, 0.001}, 0.002), 0.9F);
    for (double x = 0.103; x < 0.13; x += 0.002) grid.set(voxelAt({x, y, 0.001}, 0.002), 0.1F);
  }
  ASSERT_TRUE(toOctree(grid)->write(directory.path() + "/fine.ot"));
  const PriorSource source = fromFile(PriorFormat::kOctree, directory.path() + "/fine.ot");
  const Prior prior = makePriors(sceneWith({{}, {source}})).world.at(0);
  for (double y = -0.045; y < 0.045; y += 0.01) {
    EXPECT_EQ(saidAt(prior, {0.101, y, 0.001}), Said::kMatter);
  }
  EXPECT_NE(saidAt(prior, {0.121, 0.001, 0.001}), Said::kMatter);
}

// A building: voxels are 18 cm, of which few have their centres in a wall of 5 cm.
TEST(PriorOctrees, OctreesKeepTheirWallsWhereVoxelsGrowWithTheirExtent) {
  TemporaryDirectory directory;
  VoxelGrid grid(0.05);
  for (double y = 0.025; y < 2.0; y += 0.05) {
    grid.set(voxelAt({1.025, y, 0.025}, 0.05), 0.9F);
    for (double x : {0.925, 0.975, 1.075, 1.125}) grid.set(voxelAt({x, y, 0.025}, 0.05), 0.1F);
  }
  grid.set(voxelAt({50.025, 50.025, 10.025}, 0.05), 0.1F);
  ASSERT_TRUE(toOctree(grid)->write(directory.path() + "/building.ot"));
  Scenario scene =
      sceneWith({{}, {fromFile(PriorFormat::kOctree, directory.path() + "/building.ot")}});
  scene.motion = Motion::kSpatial;
  const Prior prior = makePriors(scene).world.at(0);
  EXPECT_GT(prior.known.voxelSize(), 0.15);
  for (double y = 0.025; y < 2.0; y += 0.05) {
    EXPECT_EQ(saidAt(prior, {1.025, y, 0.025}), Said::kMatter) << y;
  }
}

TEST(PriorOctrees, OctreesSayWhatIsMatterAndWhatIsFree) {
  TemporaryDirectory directory;
  VoxelGrid grid(0.05);
  grid.set(voxelAt({0.12, 0.02, 0.02}, 0.05), 0.9F);
  grid.set(voxelAt({0.17, 0.02, 0.02}, 0.05), 0.1F);
  const auto tree = toOctree(grid);
  ASSERT_TRUE(tree->write(directory.path() + "/map.ot"));
  ASSERT_TRUE(tree->writeBinary(directory.path() + "/map.bt"));
  for (const char* name : {"/map.ot", "/map.bt"}) {
    const PriorSource source = fromFile(PriorFormat::kOctree, directory.path() + name);
    const Prior prior = makePriors(sceneWith({{}, {source}})).world.at(0);
    EXPECT_EQ(saidAt(prior, {0.12, 0.02, 0.001}), Said::kMatter) << name;
    EXPECT_EQ(saidAt(prior, {0.17, 0.02, 0.001}), Said::kFree) << name;
    EXPECT_EQ(saidAt(prior, {0.08, 0.02, 0.001}), Said::kNothing) << name;
  }
}

// All of space is free, in eight leaves of 1638 m, of which the box asks for a little.
TEST(PriorOctrees, PrunedLeavesOfAnyWidthAreAsked) {
  TemporaryDirectory directory;
  const std::string file = directory.write(
      "wide.bt", "# Octomap OcTree binary file\nid OcTree\nsize 9\nres 0.05\ndata\nUU");
  PriorSource source = fromFile(PriorFormat::kOctree, file);
  source.box = Bounds{{0.1, 0.1, -0.1}, {0.2, 0.2, 0.1}};
  const Prior prior = makePriors(sceneWith({{}, {source}})).world.at(0);
  EXPECT_EQ(saidAt(prior, {0.15, 0.15, 0.001}), Said::kFree);
  EXPECT_EQ(saidAt(prior, {0.25, 0.15, 0.001}), Said::kNothing);
}

TEST(PriorOctrees, AnOctreeThatWasCutIsRefused) {
  TemporaryDirectory directory;
  VoxelGrid grid(0.05);
  for (int i = 0; i < 100; ++i) grid.set(voxelAt({0.05 * i, 0.02, 0.02}, 0.05), 0.9F);
  std::ostringstream whole;
  ASSERT_TRUE(toOctree(grid)->write(whole));
  const std::string bytes = whole.str();
  const auto says = [&](const std::string& content) {
    const std::string file = directory.write("damaged.ot", content);
    return problemOf(sceneWith({{}, {fromFile(PriorFormat::kOctree, file)}}));
  };
  for (const double share : {0.3, 0.5, 0.9, 0.99}) {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    EXPECT_NE(says(bytes.substr(0, length)).find("was cut or damaged"), std::string::npos) << share;
  }
  const std::string header = bytes.substr(0, bytes.find("data\n") + 5);
  EXPECT_NE(says(header + std::string(1000000, '\xff')).find("was cut or damaged"),
            std::string::npos);
}

}  // namespace
}  // namespace smore
