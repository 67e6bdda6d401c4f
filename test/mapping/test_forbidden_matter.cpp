// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <thread>

#include "smore/mapping/forbidden_matter.h"

namespace smore {
namespace {

constexpr float kCell = 0.014F;
constexpr float kDistance = 0.042F;

class Random {
 public:
  Eigen::Vector3f point(float size) {
    std::uniform_real_distribution<float> uniform(-size, size);
    return {uniform(engine_), uniform(engine_), uniform(engine_)};
  }
  Eigen::Isometry3f pose() {
    std::normal_distribution<float> normal;
    const Eigen::Quaternionf turn(normal(engine_), normal(engine_), normal(engine_),
                                  normal(engine_));
    Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
    T.linear() = turn.normalized().toRotationMatrix();
    T.translation() = point(0.2F);
    return T;
  }
  std::vector<MaskedPoint> balls(int count) {
    std::vector<MaskedPoint> result;
    for (int i = 0; i < count; ++i) result.push_back({point(0.2F), HypothesisMask{1} << (i % 64)});
    return result;
  }

 private:
  std::mt19937 engine_{3};
};

// The hypotheses with a ball nearer than `distance` at some pose.
HypothesisMask nearAtSomePose(const std::vector<MaskedPoint>& balls,
                              const std::vector<Eigen::Isometry3f>& poses,
                              const Eigen::Vector3f& point, float distance) {
  HypothesisMask mask = 0;
  for (const Eigen::Isometry3f& T : poses) {
    for (const MaskedPoint& ball : balls) {
      if ((T * ball.point - point).norm() < distance) mask |= ball.mask;
    }
  }
  return mask;
}

TEST(ForbiddenMatter, IsWhereTheOtherSideWasToTheAccuracyOfItsCells) {
  Random random;
  const std::vector<MaskedPoint> balls = random.balls(80);
  std::vector<Eigen::Isometry3f> poses;
  for (int i = 0; i < 12; ++i) poses.push_back(random.pose());
  const ForbiddenMatter forbidden(balls, poses, kDistance, kCell, false);
  // A ball and the point that is asked for are each at most half a diagonal from their cells.
  const float error = kCell * std::sqrt(3.0F);
  int some = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3f point = random.point(0.25F);
    const HypothesisMask mask = forbidden.at(point);
    EXPECT_EQ(nearAtSomePose(balls, poses, point, kDistance - error) & ~mask, 0U) << i;
    EXPECT_EQ(mask & ~nearAtSomePose(balls, poses, point, kDistance + error), 0U) << i;
    some += mask != 0 ? 1 : 0;
  }
  EXPECT_GT(some, 1000);
}

// Points on a lattice of two cells lie in the middle of cells: so do those that are asked for.
void compareBallsWithAllPairs(std::vector<MaskedPoint> balls, int asked) {
  constexpr float kHalf = kCell / 2.0F;
  for (MaskedPoint& ball : balls) {
    ball.point = (ball.point / kCell).array().round().matrix() * kCell;
  }
  const MaskGrid grid(balls, kDistance, kHalf, false);
  Random random;
  for (int i = 0; i < asked; ++i) {
    const Eigen::Vector3f near = balls[i % balls.size()].point + random.point(1.5F * kDistance);
    const Eigen::Vector3f point = (near / kHalf).array().round().matrix() * kHalf;
    // Half a cell's rounding of a distance that is equal to that of contact does not count.
    const HypothesisMask expected =
        nearAtSomePose(balls, {Eigen::Isometry3f::Identity()}, point, kDistance - 1e-5F);
    EXPECT_EQ(grid.at(point), expected) << i;
  }
}

TEST(MaskGrid, BallsAroundPointsOfTheLatticeAreExact) {
  Random random;
  compareBallsWithAllPairs(random.balls(64), 5000);
}

TEST(MaskGrid, BallsAreAsExactInALargeRoom) {
  Random random;
  std::vector<MaskedPoint> balls = random.balls(256);
  for (MaskedPoint& ball : balls) ball.point *= 20.0F;  // 8 m wide
  compareBallsWithAllPairs(balls, 5000);
}

struct Room {
  float size;      // of the other side, a multiple of 0.4 m
  float distance;  // [m]
  bool planar;
};

// All of the other side's matter swept at once, where it comes into the region.
MaskGrid sweptAtOnce(const std::vector<MaskedPoint>& balls,
                     const std::vector<Eigen::Isometry3f>& poses, const Eigen::AlignedBox3f& region,
                     const Room& room) {
  MaskGrid swept(kCell, room.planar);
  for (const Eigen::Isometry3f& T : poses) {
    for (const MaskedPoint& ball : balls) {
      const Eigen::Vector3f center = T * ball.point;
      if (region.contains(center)) swept.mark(center, ball.mask);
    }
  }
  swept.dilate(room.distance);
  return swept;
}

Eigen::Isometry3f inPlane(const Eigen::Isometry3f& T) {
  Eigen::Isometry3f result = Eigen::Isometry3f::Identity();
  result.linear() =
      Eigen::AngleAxisf(10.0F * T.translation().z(), Eigen::Vector3f::UnitZ()).toRotationMatrix();
  result.translation() << T.translation().head<2>(), 0.0F;
  return result;
}

class SweptInTiles : public testing::TestWithParam<Room> {};

// The places that are asked for straddle the borders of tiles; threads ask for the same ones.
TEST_P(SweptInTiles, IsWhatIsSweptAtOnce) {
  const Room room = GetParam();
  Random random;
  std::vector<MaskedPoint> balls = random.balls(room.planar ? 60 : 20000);
  std::vector<Eigen::Isometry3f> poses;
  for (int i = 0; i < 40; ++i) poses.push_back(random.pose());
  for (MaskedPoint& ball : balls) ball.point *= room.size;
  Eigen::Vector3f center(0.7F, 0.2F, -0.4F);
  if (room.planar) {
    center.z() = 0.0F;
    for (MaskedPoint& ball : balls) ball.point.z() = 0.0F;
    for (Eigen::Isometry3f& T : poses) T = inPlane(T);
  }
  const Eigen::Vector3f half = Eigen::Vector3f::Constant(0.14F + room.distance + kCell);
  const MaskGrid swept = sweptAtOnce(balls, poses, {center - half, center + half}, room);
  const ForbiddenMatter forbidden(balls, poses, room.distance, kCell, room.planar);
  std::vector<Eigen::Vector3f> asked;
  for (int i = 0; i < 4000; ++i) {
    asked.push_back(center + random.point(0.14F));
    if (room.planar) asked.back().z() = 0.0F;
  }
  constexpr std::size_t kThreads = 4;
  std::array<std::vector<HypothesisMask>, kThreads> told;
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      for (const Eigen::Vector3f& point : asked) told[t].push_back(forbidden.at(point));
    });
  }
  for (std::thread& thread : threads) thread.join();
  int some = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const HypothesisMask expected = swept.at(asked[i]);
    for (const auto& of_thread : told) ASSERT_EQ(of_thread[i], expected) << i;
    some += expected != 0 ? 1 : 0;
  }
  EXPECT_GT(some, 1000);
  EXPECT_LT(some, 4000);
}

INSTANTIATE_TEST_SUITE_P(Rooms, SweptInTiles,
                         testing::Values(Room{10.0F, kDistance, false}, Room{20.0F, 0.1F, false},
                                         Room{10.0F, kDistance, true}, Room{20.0F, 0.06F, true}));

TEST(ForbiddenMatter, WithoutTouchesNothingIsForbidden) {
  const ForbiddenMatter forbidden({}, {Eigen::Isometry3f::Identity()}, kDistance, kCell, false);
  EXPECT_EQ(forbidden.at(Eigen::Vector3f::Zero()), 0U);
}

// All touches at one height are no planar motion: what is above and below them is asked too.
TEST(MaskGrid, OfSpatialPointsAtHeightZeroReachesAboveAndBelow) {
  const MaskGrid grid({{Eigen::Vector3f(0.1F, 0.2F, 0.0F), 5}}, kDistance, kCell, false);
  for (const float z : {-0.03F, 0.03F}) EXPECT_EQ(grid.at(Eigen::Vector3f(0.1F, 0.2F, z)), 5U);
  const ForbiddenMatter forbidden({{Eigen::Vector3f(0.1F, 0.2F, 0.03F), 3}},
                                  {Eigen::Isometry3f::Identity()}, kDistance, kCell, false);
  EXPECT_EQ(forbidden.at(Eigen::Vector3f(0.1F, 0.2F, 0.05F)), 3U);
}

TEST(MaskGrid, OfPlanarPointsIsFlat) {
  const MaskGrid grid({{Eigen::Vector3f(0.1F, 0.2F, 0.0F), 5}}, kDistance, kCell, true);
  EXPECT_EQ(grid.at(Eigen::Vector3f(0.1F, 0.23F, 0.0F)), 5U);
  EXPECT_EQ(grid.at(Eigen::Vector3f(0.1F, 0.2F, 0.02F)), 0U);
  EXPECT_EQ(grid.at(Eigen::Vector3f(0.1F, 0.26F, 0.0F)), 0U);
}

}  // namespace
}  // namespace smore
