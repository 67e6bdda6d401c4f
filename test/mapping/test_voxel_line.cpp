// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <set>

#include "smore/mapping/voxel_line.h"

namespace smore {
namespace {

// Length of the part of the segment a-b inside of the voxel, as a share of the segment.
double shareInside(const Vec3& a, const Vec3& b, const VoxelKey& key, double size) {
  double enter = 0.0;
  double leave = 1.0;
  const Vec3 low = voxelCenter(key, size) - Vec3::Constant(0.5 * size);
  for (int i = 0; i < 3; ++i) {
    const double direction = b[i] - a[i];
    const double t0 = (low[i] - a[i]) / direction;
    const double t1 = (low[i] + size - a[i]) / direction;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return leave - enter;
}

TEST(VoxelsOnSegment, areAllThatItCrossesAndNoOther) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  constexpr double kSize = 0.03;
  for (int repeat = 0; repeat < 300; ++repeat) {
    const Vec3 a(uniform(random), uniform(random), uniform(random));
    const Vec3 b(uniform(random), uniform(random), uniform(random));
    const auto line = voxelsOnSegment(a, b, kSize);
    EXPECT_EQ(line.front(), voxelAt(a, kSize));
    EXPECT_EQ(line.back(), voxelAt(b, kSize));
    const std::set<VoxelKey> visited(line.begin(), line.end());
    EXPECT_EQ(visited.size(), line.size()) << "a voxel was visited twice";
    double covered = 0.0;
    for (const VoxelKey& key : line) {
      const double share = shareInside(a, b, key, kSize);
      EXPECT_GE(share, -1e-9) << "a voxel that the segment does not cross";
      covered += share;
    }
    EXPECT_NEAR(covered, 1.0, 1e-9) << "a voxel is missing";
  }
}

TEST(VoxelsOnSegment, areNeighboursByAFace) {
  const auto line = voxelsOnSegment(Vec3(-0.5, 0.3, 0.1), Vec3(0.4, -0.2, 0.0), 0.05);
  for (std::size_t i = 1; i < line.size(); ++i) {
    EXPECT_EQ(std::abs(line[i].x - line[i - 1].x) + std::abs(line[i].y - line[i - 1].y) +
                  std::abs(line[i].z - line[i - 1].z),
              1);
  }
}

TEST(VoxelsOnSegment, areOneWhereBothEndsShareAVoxel) {
  EXPECT_EQ(voxelsOnSegment(Vec3(0.01, 0.01, 0.01), Vec3(0.02, 0.02, 0.02), 0.03).size(), 1u);
}

TEST(VoxelsOnSegment, holdBothEndsAlongAnAxisInBothDirections) {
  const Vec3 a(-0.1, 0.05, 0.05);
  const Vec3 b(1.0, 0.05, 0.05);
  const auto forth = voxelsOnSegment(a, b, 0.1);
  EXPECT_EQ(forth.size(), 12u);  // -1 to 10
  EXPECT_EQ(voxelsOnSegment(b, a, 0.1).size(), 12u);
}

TEST(VoxelsOnSegment, passExactCornersOneAxisAtATime) {
  const auto line = voxelsOnSegment(Vec3(0.5, 0.5, 0.5), Vec3(1.5, 1.5, 1.5), 1.0);
  ASSERT_EQ(line.size(), 4u);
  EXPECT_EQ(line[1], (VoxelKey{1, 0, 0}));
  EXPECT_EQ(line[2], (VoxelKey{1, 1, 0}));
  EXPECT_EQ(line[3], (VoxelKey{1, 1, 1}));
}

}  // namespace
}  // namespace smore
