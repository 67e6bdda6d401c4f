// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "nearest_forest.h"

namespace smore {
namespace {

using Point = std::pair<double, double>;

NearestForest<Point> makeForest() {
  NearestForest<Point> forest;
  forest.setDistanceFunction([](const Point& a, const Point& b) {
    return std::hypot(a.first - b.first, a.second - b.second);
  });
  return forest;
}

TEST(NearestForestTest, findsTheNearestAfterEachInsertion) {
  auto forest = makeForest();
  const auto& distance = forest.getDistanceFunction();
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Point> points;
  for (int i = 0; i < 1500; ++i) {
    points.emplace_back(uniform(engine), uniform(engine));
    forest.add(points.back());
    const Point query(uniform(engine), uniform(engine));
    const auto nearer = [&](const Point& a, const Point& b) {
      return distance(a, query) < distance(b, query);
    };
    ASSERT_EQ(forest.nearest(query), *std::min_element(points.begin(), points.end(), nearer));
  }
  EXPECT_EQ(forest.size(), points.size());
}

TEST(NearestForestTest, holdsPointsThatAllCoincide) {
  auto forest = makeForest();
  for (int i = 0; i < 200; ++i) forest.add(Point(0.5, 0.5));
  forest.add(Point(0.0, 0.0));
  EXPECT_EQ(forest.nearest(Point(0.6, 0.5)), Point(0.5, 0.5));
  EXPECT_EQ(forest.nearest(Point(0.1, 0.1)), Point(0.0, 0.0));
}

TEST(NearestForestTest, listsRangesAndRemoves) {
  auto forest = makeForest();
  for (int i = 0; i < 100; ++i) forest.add(Point(i, 0.0));
  std::vector<Point> found;
  forest.nearestK(Point(10.2, 0.0), 3, found);
  EXPECT_EQ(found, (std::vector<Point>{{10, 0}, {11, 0}, {9, 0}}));
  forest.nearestR(Point(10.2, 0.0), 1.0, found);
  EXPECT_EQ(found, (std::vector<Point>{{10, 0}, {11, 0}}));
  EXPECT_TRUE(forest.remove(Point(10, 0)));
  EXPECT_FALSE(forest.remove(Point(10, 0)));
  EXPECT_EQ(forest.nearest(Point(10.2, 0.0)), Point(11, 0));
  forest.clear();
  EXPECT_EQ(forest.size(), 0U);
}

}  // namespace
}  // namespace smore
