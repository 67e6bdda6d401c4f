// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/planning/distance_field.h"
#include "smore/planning/sphere_tree.h"
#include "voxel_oracle.h"

namespace smore {
namespace {

double nearest(const OccupiedVoxels& voxels, const Vec3& point) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Vec3& center : centersOf(voxels)) {
    distance = std::min(distance, (center - point).norm());
  }
  return distance;
}

OccupiedVoxels scattered(unsigned seed, int count, int reach, double size) {
  std::mt19937 engine(seed);
  std::uniform_int_distribution<int> index(-reach, reach);
  OccupiedVoxels voxels{size, {}};
  const auto draw = [&] { return static_cast<std::int16_t>(index(engine)); };
  for (int i = 0; i < count; ++i) {
    const std::int16_t x = draw();
    const std::int16_t y = draw();
    voxels.keys.push_back({x, y, draw()});
  }
  return voxels;
}

TEST(DistanceFieldTest, infiniteWithoutVoxels) {
  EXPECT_EQ(DistanceField({0.03, {}}).at(Vec3::Zero()).least,
            std::numeric_limits<double>::infinity());
}

TEST(DistanceFieldTest, exactAtTheCentresOfVoxelsInsideTheBox) {
  const OccupiedVoxels voxels = scattered(1, 30, 12, 0.03);
  const DistanceField field(voxels);
  VoxelKey low{99, 99, 99};
  VoxelKey high{-99, -99, -99};
  for (const VoxelKey& key : voxels.keys) {
    low = {std::min(low.x, key.x), std::min(low.y, key.y), std::min(low.z, key.z)};
    high = {std::max(high.x, key.x), std::max(high.y, key.y), std::max(high.z, key.z)};
  }
  for (std::int16_t x = low.x; x <= high.x; ++x) {
    for (std::int16_t y = low.y; y <= high.y; ++y) {
      for (std::int16_t z = low.z; z <= high.z; ++z) {
        const Vec3 center = voxelCenter({x, y, z}, 0.03);
        ASSERT_NEAR(field.at(center).least, nearest(voxels, center), 1e-6);
      }
    }
  }
}

TEST(DistanceFieldTest, neverAboveTheDistanceAndWithinACellOfItInside) {
  const OccupiedVoxels voxels = scattered(2, 40, 15, 0.05);
  const DistanceField field(voxels);
  oracle::PoseSource points(3, 1.5, false);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 point = points.next().translation();
    const double truth = nearest(voxels, point);
    ASSERT_LE(field.at(point).least, truth + 1e-6);
    ASSERT_GE(field.at(point).most, truth - 1e-6);
    if (point.cwiseAbs().maxCoeff() > 0.5) continue;
    ASSERT_GE(field.at(point).least, truth - std::sqrt(3.0) * 0.05);
  }
}

TEST(DistanceFieldTest, voxelsFarApartStayWithinTheMemoryLimit) {
  const OccupiedVoxels voxels = scattered(4, 50, 20000, 0.01);
  const DistanceField field(voxels);
  oracle::PoseSource points(5, 250.0, false);
  for (int i = 0; i < 500; ++i) {
    const Vec3 point = points.next().translation();
    const double truth = nearest(voxels, point);
    ASSERT_LE(field.at(point).least, truth + 1e-3);
    ASSERT_GE(field.at(point).most, truth - 1e-3);
  }
  EXPECT_GT(field.at(Vec3(1000, 0, 0)).least, 700.0);
}

TEST(SphereTreeTest, spheresHoldAllPointsBelowThem) {
  std::vector<Vec3> points;
  points.reserve(301);
  oracle::PoseSource source(6, 1.0, false);
  for (int i = 0; i < 300; ++i) points.emplace_back(source.next().translation());
  points.push_back(points.front());
  const SphereTree tree(points);
  ASSERT_EQ(tree.nodes().size(), 2 * points.size() - 1);
  std::vector<int> seen(points.size(), 0);
  const std::function<std::vector<std::uint32_t>(std::uint32_t)> below = [&](std::uint32_t index) {
    const SphereTree::Node& node = tree.nodes()[index];
    if (SphereTree::isLeaf(node)) {
      ++seen[node.point];
      return std::vector<std::uint32_t>{node.point};
    }
    std::vector<std::uint32_t> all = below(node.left);
    const std::vector<std::uint32_t> right = below(node.right);
    all.insert(all.end(), right.begin(), right.end());
    for (const std::uint32_t point : all) {
      EXPECT_LE((points[point] - node.center).norm(), node.radius + 1e-12);
    }
    return all;
  };
  below(0);
  EXPECT_EQ(seen, std::vector<int>(points.size(), 1));
  EXPECT_TRUE(SphereTree({}).nodes().empty());
}

}  // namespace
}  // namespace smore
