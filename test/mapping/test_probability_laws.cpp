// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "smore/mapping/probability_laws.h"

namespace smore {
namespace {

constexpr double kMin = 0.005;  // clamps of the maps
constexpr double kMax = 0.995;

// Marginals of p and q after "at least one pair touches" (or none does), by summing over all joint
// states of the pairs: each pair is in one of four states.
std::vector<VoxelPair> enumerate(const std::vector<VoxelPair>& pairs, bool touches) {
  const int n = static_cast<int>(pairs.size());
  std::vector<VoxelPair> sums(n);
  double total = 0.0;
  for (long state = 0; state < 1L << (2 * n); ++state) {
    double weight = 1.0;
    bool any = false;
    for (int i = 0; i < n; ++i) {
      const bool a = (state >> (2 * i)) & 1;
      const bool b = (state >> (2 * i + 1)) & 1;
      weight *= (a ? pairs[i].p : 1 - pairs[i].p) * (b ? pairs[i].q : 1 - pairs[i].q);
      any = any || (a && b);
    }
    if (any != touches) continue;
    total += weight;
    for (int i = 0; i < n; ++i) {
      if ((state >> (2 * i)) & 1) sums[i].p += weight;
      if ((state >> (2 * i + 1)) & 1) sums[i].q += weight;
    }
  }
  for (VoxelPair& sum : sums) sum = {sum.p / total, sum.q / total};
  return sums;
}

void expectSame(const std::vector<VoxelPair>& actual, const std::vector<VoxelPair>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i].p, expected[i].p, 1e-9);
    EXPECT_NEAR(actual[i].q, expected[i].q, 1e-9);
  }
}

TEST(ContactLaw, isTheExactMarginalForRandomPairs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(kMin, kMax);
  for (int n = 1; n <= 8; ++n) {
    for (int repeat = 0; repeat < 5; ++repeat) {
      std::vector<VoxelPair> pairs(n);
      for (VoxelPair& pair : pairs) pair = {uniform(random), uniform(random)};
      expectSame(contactLaw(pairs), enumerate(pairs, true));
    }
  }
}

TEST(ContactLaw, isTheExactMarginalForTwelvePairs) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(kMin, 0.3);
  std::vector<VoxelPair> pairs(12);
  for (VoxelPair& pair : pairs) pair = {uniform(random), uniform(random)};
  expectSame(contactLaw(pairs), enumerate(pairs, true));
}

TEST(ContactLaw, isExactAtTheClamps) {
  const std::vector<std::vector<VoxelPair>> cases = {
      {{kMin, kMin}},
      {{kMax, kMax}},
      {{kMin, kMax}},
      {{kMin, kMin}, {kMin, kMin}, {kMin, kMin}},
      {{kMax, kMax}, {kMax, kMax}, {kMin, kMin}},
      {{kMax, kMin}, {kMin, kMax}, {0.5, 0.5}},
  };
  for (const auto& pairs : cases) expectSame(contactLaw(pairs), enumerate(pairs, true));
}

TEST(ContactLaw, ofOnePairMakesBothOccupied) {
  const auto posterior = contactLaw({{0.1, 0.2}});
  EXPECT_NEAR(posterior[0].p, 1.0, 1e-12);
  EXPECT_NEAR(posterior[0].q, 1.0, 1e-12);
}

TEST(ContactLaw, keepsItsDigitsForTinyPriors) {
  // With n equal pairs of tiny priors each is the contact with probability 1 / n.
  const int n = 5;
  const auto posterior = contactLaw(std::vector<VoxelPair>(n, {1e-9, 1e-9}));
  for (const VoxelPair& pair : posterior) EXPECT_NEAR(pair.p, 1.0 / n, 1e-6);
}

TEST(ContactLaw, learnsNothingFromNoPairsOrImpossibleOnes) {
  EXPECT_TRUE(contactLaw({}).empty());
  const auto posterior = contactLaw({{0.0, 0.7}, {0.4, 0.0}});
  EXPECT_EQ(posterior[0].q, 0.7);
  EXPECT_EQ(posterior[1].p, 0.4);
}

TEST(ContactLaw, leavesTheOthersWhenOnePairIsCertain) {
  const auto posterior = contactLaw({{1.0, 1.0}, {0.3, 0.4}});
  EXPECT_EQ(posterior[1].p, 0.3);
  EXPECT_EQ(posterior[1].q, 0.4);
}

TEST(ContactLaw, neverLowersAProbability) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(kMin, kMax);
  for (int repeat = 0; repeat < 200; ++repeat) {
    std::vector<VoxelPair> pairs(20);
    for (VoxelPair& pair : pairs) pair = {uniform(random), uniform(random)};
    const auto posterior = contactLaw(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_GE(posterior[i].p, pairs[i].p - 1e-12);
      EXPECT_GE(posterior[i].q, pairs[i].q - 1e-12);
      EXPECT_LE(posterior[i].p, 1.0 + 1e-12);
    }
  }
}

TEST(FreeSpaceLaw, givesThePapersFigure4) {
  const VoxelPair posterior = freeSpaceLaw({0.79, 0.21});
  EXPECT_NEAR(posterior.p, 0.75, 0.005);
  EXPECT_NEAR(posterior.q, 0.05, 0.005);
}

TEST(FreeSpaceLaw, isTheExactMarginal) {
  for (const double p : {0.0, kMin, 0.21, 0.5, 0.79, kMax}) {
    for (const double q : {0.0, kMin, 0.21, 0.5, 0.79, kMax}) {
      expectSame({freeSpaceLaw({p, q})}, enumerate({{p, q}}, false));
    }
  }
}

TEST(FreeSpaceLaw, dividesTheOddsByOnePlusTheOthersOdds) {
  const double p = 0.6;
  const double q = 0.8;
  const VoxelPair posterior = freeSpaceLaw({p, q});
  EXPECT_NEAR(posterior.p / (1 - posterior.p), (p / (1 - p)) / (1 + q / (1 - q)), 1e-12);
}

TEST(FreeSpaceLaw, leavesACertainContradictionAsItIs) {
  const VoxelPair posterior = freeSpaceLaw({1.0, 1.0});
  EXPECT_EQ(posterior.p, 1.0);
  EXPECT_EQ(posterior.q, 1.0);
}

}  // namespace
}  // namespace smore
