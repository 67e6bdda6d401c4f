// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numeric>

#include "smore/mapping/hypothesis_weights.h"

namespace smore {
namespace {

HypothesisWeights::Founders numbered(int founders) {
  HypothesisWeights::Founders result{};
  for (int m = 0; m < kHypotheses; ++m) result[m] = m % founders;
  return result;
}

TEST(HypothesisWeights, AreSharesOfTheirSum) {
  HypothesisWeights::Weights weights{};
  std::iota(weights.begin(), weights.end(), 0.0);
  const HypothesisWeights weighted(weights, numbered(kHypotheses));
  EXPECT_NEAR(weighted.shareOf(~HypothesisMask{0}), 1.0, 1e-12);
  EXPECT_NEAR(weighted.shareOf((HypothesisMask{1} << 3) | (HypothesisMask{1} << 63)), 66.0 / 2016.0,
              1e-12);
  EXPECT_DOUBLE_EQ(HypothesisWeights().shareOf(0xFF00FF), 0.25);
}

TEST(HypothesisWeights, CountWhatIsEqualAndIndependent) {
  EXPECT_NEAR(HypothesisWeights().effectiveCount(), kHypotheses, 1e-9);
  HypothesisWeights::Weights weights{};
  weights.fill(3.0);
  EXPECT_NEAR(HypothesisWeights(weights, numbered(4)).effectiveCount(), 4.0, 1e-9);
  EXPECT_NEAR(HypothesisWeights(weights, numbered(1)).effectiveCount(), 1.0, 1e-9);
  // Two that weigh alike and nothing else, of two founders and of one.
  weights.fill(0.0);
  weights[0] = weights[1] = 1.0;
  EXPECT_NEAR(HypothesisWeights(weights, numbered(2)).effectiveCount(), 2.0, 1e-9);
  EXPECT_NEAR(HypothesisWeights(weights, numbered(1)).effectiveCount(), 1.0, 1e-9);
}

}  // namespace
}  // namespace smore
