// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "smore/mapping/matter_overlap.h"

namespace smore {
namespace {

constexpr float kDistance = 0.02F;
constexpr int kAll = kHypotheses;

// Points in clumps, as matter around touches, all over a cube of this size; in a few hypotheses
// each.
std::vector<MaskedPoint> clumps(int count, float size, bool planar, std::mt19937_64* random) {
  std::uniform_real_distribution<float> anywhere(-0.5F * size, 0.5F * size);
  std::normal_distribution<float> near(0.0F, 2.0F * kDistance);
  MaskedPoints points(kDistance / 3.0F);
  for (int clump = 0; clump < count; ++clump) {
    const Eigen::Vector3f center(anywhere(*random), anywhere(*random), anywhere(*random));
    const HypothesisMask mask = (*random)() & (*random)();
    for (int i = 0; i < 12; ++i) {
      Eigen::Vector3f point = center + Eigen::Vector3f(near(*random), near(*random), near(*random));
      if (planar) point.z() = 0.0F;
      points.add(point, mask);
    }
  }
  return points.points();
}

Eigen::Isometry3f pose(float size, bool planar, std::mt19937_64* random) {
  std::uniform_real_distribution<float> shift(-0.4F * size, 0.4F * size);
  std::normal_distribution<float> part;
  Eigen::Isometry3f result = Eigen::Isometry3f::Identity();
  result.translation() << shift(*random), shift(*random), planar ? 0.0F : shift(*random);
  Eigen::Quaternionf turn(part(*random), part(*random), part(*random), part(*random));
  if (planar) turn.x() = turn.y() = 0.0F;
  result.linear() = turn.normalized().toRotationMatrix();
  return result;
}

// Hypotheses in which some balls' centres are nearer than `distance`.
HypothesisMask pairsWithin(float distance, const std::vector<MaskedPoint>& object,
                           const std::vector<MaskedPoint>& world, const Eigen::Isometry3f& pose) {
  HypothesisMask result = 0;
  for (const MaskedPoint& a : object) {
    const Eigen::Vector3f place = pose * a.point;
    for (const MaskedPoint& b : world) {
      if ((place - b.point).norm() < distance) result |= a.mask & b.mask;
    }
  }
  return result;
}

struct Case {
  int object;  // clumps
  int world;
  float size;  // of what they lie in [m]
  bool planar;
};

class Overlap : public testing::TestWithParam<Case> {};

// Places are rounded to cells of a sixth of the distance, both of them.
TEST_P(Overlap, IsWhatAllPairsSay) {
  const Case given = GetParam();
  std::mt19937_64 random(7);
  const auto object = clumps(given.object, given.size, given.planar, &random);
  const auto world = clumps(given.world, given.size, given.planar, &random);
  const MatterOverlap overlap(object, world, {kDistance}, 2.0F * kDistance, given.planar);
  int touching = 0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Isometry3f at = pose(given.size, given.planar, &random);
    const HypothesisMask found = overlap.at(at, kAll);
    EXPECT_EQ(pairsWithin(0.7F * kDistance, object, world, at) & ~found, 0U) << i;
    EXPECT_EQ(found & ~pairsWithin(1.3F * kDistance, object, world, at), 0U) << i;
    touching += found != 0 ? 1 : 0;
  }
  EXPECT_GT(touching, 15);
  EXPECT_LT(touching, 300);
}

// Matter 300 m from the origin, in cells of a fifth of a millimetre.
TEST(MaskedPoints, TellsPlacesApartFarFromTheOrigin) {
  constexpr float kCell = 2e-4F;
  for (const float far : {-300.0F, 300.0F}) {
    const auto key = MaskedPoints::cellKey({0.0F, far, 0.0F}, kCell);
    EXPECT_NE(key, MaskedPoints::cellKey({0.5F, far, 0.0F}, kCell));
    EXPECT_NE(key, MaskedPoints::cellKey({0.0F, far, 0.5F}, kCell));
    EXPECT_NE(key, MaskedPoints::cellKey({0.0F, far + 0.5F, 0.0F}, kCell));
  }
}

// Two balls, and the same ball for all worlds: the nearer, the more of them touch.
TEST(OverlapOfASpread, GrowsEvenlyWithHowNearTheBallsAre) {
  constexpr float kSpread = 0.5F * kDistance;
  const std::vector<MaskedPoint> ball = {{Eigen::Vector3f::Zero(), ~HypothesisMask{0}}};
  const MatterOverlap overlap(ball, ball, {kDistance, kSpread}, 2.0F * kDistance, true);
  Eigen::Isometry3f at = Eigen::Isometry3f::Identity();
  HypothesisMask before = ~HypothesisMask{0};
  for (float share = -1.2F; share <= 1.2F; share += 0.05F) {
    at.translation().x() = kDistance + share * kSpread;
    const HypothesisMask found = overlap.at(at, kAll);
    EXPECT_EQ(found & ~before, 0U) << "who touches from afar touches from nearby";
    const float expected = std::clamp(0.5F - 0.5F * share, 0.0F, 1.0F) * kHypotheses;
    EXPECT_NEAR(__builtin_popcountll(found), expected, 16) << share;  // an eighth, and a cell
    before = found;
  }
  EXPECT_EQ(before, 0U);
}

// The worlds with the smallest surfaces have as wide distances as those with the largest.
TEST(OverlapOfASpread, IsTheSameForWorldsOfAllSizes) {
  const std::vector<MaskedPoint> ball = {{Eigen::Vector3f::Zero(), ~HypothesisMask{0}}};
  const MatterOverlap overlap(ball, ball, {kDistance, 0.5F * kDistance}, 2.0F * kDistance, true);
  Eigen::Isometry3f at = Eigen::Isometry3f::Identity();
  at.translation().x() = kDistance;
  const HypothesisMask found = overlap.at(at, kAll);
  for (int eighth = 0; eighth < 8; ++eighth) {
    const int count = __builtin_popcountll(found >> (8 * eighth) & 0xFFU);
    EXPECT_NEAR(count, __builtin_popcountll(found) / 8.0, 1.0) << eighth;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Overlap,
                         testing::Values(Case{4, 9, 1.0F, true}, Case{9, 4, 0.2F, false},
                                         Case{60, 60, 1.2F, false}, Case{40, 40, 8.0F, true}));

}  // namespace
}  // namespace smore
