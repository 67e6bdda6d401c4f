// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "smore/mapping/joined_touches.h"

namespace smore {
namespace {

using Points = std::vector<Eigen::Vector3f>;
constexpr float kDistance = 0.04F;

bool everywhere(const Eigen::Vector3f& /*point*/) { return true; }

// Whether steps of at most `kDistance` over the points lead from the first place to all others.
bool inOnePiece(const Points& places, Points points) {
  points.insert(points.end(), places.begin(), places.end());
  Points reached = {places.front()};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const auto far = [&](const Eigen::Vector3f& point) {
      return (point - reached[i]).norm() > kDistance;
    };
    const auto near = std::stable_partition(points.begin(), points.end(), far);
    reached.insert(reached.end(), near, points.end());
    points.erase(near, points.end());
  }
  return points.empty();
}

TEST(JoinedTouches, MakesOnePieceOfAllPlaces) {
  const Points places = {
      {0.0F, 0.0F, 0.0F}, {0.3F, 0.0F, 0.0F}, {0.3F, 0.2F, 0.1F}, {-0.2F, -0.1F, 0.2F}};
  for (int seed = 1; seed <= 20; ++seed) {
    CounterRandom random(seed);
    EXPECT_TRUE(inOnePiece(places, joinTouches(places, kDistance, everywhere, &random))) << seed;
  }
}

TEST(JoinedTouches, GoesAroundWhatIsNotAllowed) {
  const Points places = {{-0.15F, 0.0F, 0.0F}, {0.15F, 0.0F, 0.0F}};
  const auto allowed = [](const Eigen::Vector3f& point) { return point.norm() > 0.03F; };
  int joined = 0;
  for (int seed = 1; seed <= 50; ++seed) {
    CounterRandom random(seed);
    const Points points = joinTouches(places, kDistance, allowed, &random);
    for (const Eigen::Vector3f& point : points) EXPECT_TRUE(allowed(point));
    joined += points.empty() ? 0 : 1;
  }
  EXPECT_GT(joined, 45) << "a small obstacle has ways around it";
}

TEST(JoinedTouches, LeavesOutATieThatNothingAllows) {
  const Points places = {{-0.15F, 0.0F, 0.0F}, {0.15F, 0.0F, 0.0F}};
  const auto allowed = [](const Eigen::Vector3f& point) { return std::abs(point.x()) > 0.05F; };
  CounterRandom random(1);
  EXPECT_TRUE(joinTouches(places, kDistance, allowed, &random).empty());
}

TEST(JoinedTouches, PlacesThatAreNearCountOnce) {
  CounterRandom random(1);
  const Points places = {{0.0F, 0.0F, 0.0F}, {0.01F, 0.0F, 0.0F}, {0.0F, 0.03F, 0.0F}};
  EXPECT_TRUE(joinTouches(places, kDistance, everywhere, &random).empty());
  EXPECT_TRUE(joinTouches({}, kDistance, everywhere, &random).empty());
}

}  // namespace
}  // namespace smore
