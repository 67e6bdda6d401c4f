// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "smore/mapping/counter_random.h"
#include "smore/mapping/joined_touches.h"

namespace smore {
namespace {

using Points = std::vector<Eigen::Vector3f>;
constexpr float kDistance = 0.04F;
constexpr float kAnyLength = 10.0F;

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
  for (int seed = 1; seed <= 20; ++seed) {
    CounterRandom random(seed);
    Points places(12);
    for (Eigen::Vector3f& place : places) {
      place = Eigen::Vector3f::NullaryExpr([&] { return static_cast<float>(random.uniform()); });
    }
    for (const float longest_closing : {0.0F, kAnyLength}) {
      const Points points = joinTouches(places, kDistance, longest_closing, everywhere);
      EXPECT_TRUE(inOnePiece(places, points)) << seed;
    }
  }
}

TEST(JoinedTouches, DoesNotJoinPlacesWithAThirdBetweenThem) {
  const Points places = {{-0.2F, 0.0F, 0.0F}, {0.2F, 0.0F, 0.0F}, {0.0F, 0.15F, 0.0F}};
  const Points points = joinTouches(places, kDistance, kAnyLength, everywhere);
  EXPECT_TRUE(inOnePiece(places, points));
  for (const Eigen::Vector3f& point : points) {
    const float height = 0.15F - 0.75F * std::abs(point.x());
    EXPECT_NEAR(point.y(), height, 1e-5F) << "beside the two short sides of the triangle";
  }
}

TEST(JoinedTouches, JoinsPlacesWithAThirdBesideThem) {
  const Points places = {{-0.2F, 0.0F, 0.0F}, {0.2F, 0.0F, 0.0F}, {0.0F, 0.25F, 0.0F}};
  const Points points = joinTouches(places, kDistance, kAnyLength, everywhere);
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const Eigen::Vector3f& point) {
    return std::abs(point.y()) < 1e-5F;
  }));
}

// A hook: a ring of twelve places without three of them.
TEST(JoinedTouches, LeavesAMouthOpenThatIsWiderThanRingsAreClosed) {
  Points places;
  for (int i = 2; i <= 10; ++i) {
    const float angle = static_cast<float>(i) * static_cast<float>(M_PI) / 6.0F;
    places.emplace_back(0.2F * std::cos(angle), 0.2F * std::sin(angle), 0.0F);
  }
  const float mouth = (places.front() - places.back()).norm();
  const auto is_closed = [&](float longest_closing) {
    const Points points = joinTouches(places, kDistance, longest_closing, everywhere);
    EXPECT_TRUE(inOnePiece(places, points));
    return std::any_of(points.begin(), points.end(), [](const Eigen::Vector3f& point) {
      return point.x() > 0.0F && std::abs(point.y()) < kDistance;
    });
  };
  EXPECT_FALSE(is_closed(0.99F * mouth));
  EXPECT_TRUE(is_closed(1.01F * mouth));
}

TEST(JoinedTouches, GoesAroundAWayThatIsNotAllowed) {
  const Points places = {{-0.15F, 0.0F, 0.0F}, {0.15F, 0.0F, 0.0F}, {0.0F, 0.28F, 0.0F}};
  const auto allowed = [](const Eigen::Vector3f& point) { return point.y() > 0.01F; };
  EXPECT_TRUE(inOnePiece(places, joinTouches(places, kDistance, 0.0F, allowed)));
}

TEST(JoinedTouches, LeavesOutAWayThatIsNotAllowed) {
  const Points places = {{-0.15F, 0.0F, 0.0F}, {0.15F, 0.0F, 0.0F}};
  const auto allowed = [](const Eigen::Vector3f& point) { return std::abs(point.x()) > 0.02F; };
  EXPECT_TRUE(joinTouches(places, kDistance, kAnyLength, allowed).empty());
}

TEST(JoinedTouches, AsksNothingNearPlaces) {
  const Points places = {{-0.15F, 0.0F, 0.0F}, {0.15F, 0.0F, 0.0F}};
  const auto allowed = [](const Eigen::Vector3f& point) { return std::abs(point.x()) < 0.12F; };
  EXPECT_TRUE(inOnePiece(places, joinTouches(places, kDistance, kAnyLength, allowed)));
}

TEST(JoinedTouches, PlacesThatAreNearCountOnce) {
  const Points places = {{0.0F, 0.0F, 0.0F}, {0.01F, 0.0F, 0.0F}, {0.0F, 0.03F, 0.0F}};
  EXPECT_TRUE(joinTouches(places, kDistance, kAnyLength, everywhere).empty());
  EXPECT_TRUE(joinTouches({}, kDistance, kAnyLength, everywhere).empty());
}

}  // namespace
}  // namespace smore
