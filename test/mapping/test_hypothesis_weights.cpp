// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "smore/mapping/hypothesis_weights.h"

namespace smore {
namespace {

TEST(HypothesisWeights, AreSharesOfTheirSum) {
  HypothesisWeights::Weights weights{};
  std::iota(weights.begin(), weights.end(), 0.0);
  const HypothesisWeights weighted(weights);
  EXPECT_NEAR(weighted.shareOf(~HypothesisMask{0}), 1.0, 1e-12);
  EXPECT_NEAR(weighted.shareOf((HypothesisMask{1} << 3) | (HypothesisMask{1} << 63)), 66.0 / 2016.0,
              1e-12);
  EXPECT_DOUBLE_EQ(HypothesisWeights().shareOf(0xFF00FF), 0.25);
}

TEST(HypothesisWeights, CountForAsManyAsWouldSayAsMuch) {
  EXPECT_NEAR(HypothesisWeights().effectiveCount(), kHypotheses, 1e-9);
  HypothesisWeights::Weights weights{};
  for (int m = 0; m < kHypotheses; ++m) {
    weights[m] = 3.0;
    EXPECT_NEAR(HypothesisWeights(weights).effectiveCount(), m + 1.0, 1e-9);
  }
  std::fill(weights.begin() + 8, weights.end(), 0.03);
  EXPECT_NEAR(HypothesisWeights(weights).effectiveCount(), 8.56 * 8.56 / 8.0056, 1e-9);
}

}  // namespace
}  // namespace smore
