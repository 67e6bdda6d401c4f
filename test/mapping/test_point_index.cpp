// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "smore/mapping/point_index.h"

namespace smore {
namespace {

constexpr float kRadius = 0.042F;

std::vector<Eigen::Vector3f> cloud(int count, float size, const Eigen::Vector3f& center) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<float> uniform(-size, size);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(center +
                        Eigen::Vector3f(uniform(engine), uniform(engine), uniform(engine)));
  }
  return points;
}

std::vector<int> nearByAllPairs(const std::vector<Eigen::Vector3f>& points,
                                const Eigen::Vector3f& place) {
  std::vector<int> near;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    if ((points[i] - place).squaredNorm() < kRadius * kRadius) near.push_back(i);
  }
  return near;
}

void compareWithAllPairs(const std::vector<Eigen::Vector3f>& points) {
  PointIndex index(kRadius);
  index.build(points);
  int found = 0;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f place = point + Eigen::Vector3f(0.02F, -0.01F, 0.005F);
    std::vector<int> near;
    index.forNear(place, [&near](int i) { near.push_back(i); });
    std::sort(near.begin(), near.end());
    EXPECT_EQ(near, nearByAllPairs(points, place));
    found += static_cast<int>(near.size());
  }
  EXPECT_GE(found, static_cast<int>(points.size()));
}

TEST(PointIndex, FindsWhatAllPairsFind) {
  compareWithAllPairs(cloud(400, 0.2F, Eigen::Vector3f::Zero()));
}

// Inside of the box that the points lie in, at its faces and just outside of them.
TEST(PointIndex, FindsThemFromAllAroundThem) {
  const std::vector<Eigen::Vector3f> points = cloud(60, 0.1F, {3.0F, -2.0F, 1.0F});
  PointIndex index(kRadius);
  index.build(points);
  std::mt19937 engine(6);
  std::uniform_real_distribution<float> uniform(-0.1F - 2.0F * kRadius, 0.1F + 2.0F * kRadius);
  int beside = 0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3f offset(uniform(engine), uniform(engine), uniform(engine));
    const Eigen::Vector3f place = offset + Eigen::Vector3f(3.0F, -2.0F, 1.0F);
    std::vector<int> near;
    index.forNear(place, [&near](int k) { near.push_back(k); });
    std::sort(near.begin(), near.end());
    EXPECT_EQ(near, nearByAllPairs(points, place));
    beside += !near.empty() && offset.cwiseAbs().maxCoeff() > 0.1F ? 1 : 0;
  }
  EXPECT_GT(beside, 100);
}

TEST(PointIndex, FindsTheSameWhereTwoPlacesLieAKilometreApart) {
  std::vector<Eigen::Vector3f> points = cloud(100, 0.1F, Eigen::Vector3f::Zero());
  const std::vector<Eigen::Vector3f> far = cloud(100, 0.1F, {600.0F, 500.0F, 700.0F});
  points.insert(points.end(), far.begin(), far.end());
  compareWithAllPairs(points);
}

TEST(PointIndex, FindsNothingWithoutPointsAndFarFromThem) {
  PointIndex index(kRadius);
  const auto fail = [](int) { FAIL(); };
  index.forNear(Eigen::Vector3f::Zero(), fail);
  index.build(cloud(10, 0.1F, Eigen::Vector3f::Zero()));
  index.forNear(Eigen::Vector3f::Constant(9.0F), fail);
}

}  // namespace
}  // namespace smore
