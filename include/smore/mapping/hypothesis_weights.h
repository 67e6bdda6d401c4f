// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "smore/mapping/mask_bricks.h"

namespace smore {

/// How likely each sampled explanation is, where they are not equally so.
class HypothesisWeights {
 public:
  using Weights = std::array<double, kHypotheses>;

  /// All equal.
  HypothesisWeights();

  /// Not negative, not all 0; of any sum.
  explicit HypothesisWeights(const Weights& weights);

  /// Probability that one of the hypotheses in the mask is true; from 0 to 1.
  double shareOf(HypothesisMask mask) const {
    double share = 0.0;
    for (int byte = 0; byte < kBytes; ++byte) share += shares_[byte][(mask >> (8 * byte)) & 0xFF];
    return share;
  }

  /// As many hypotheses of equal weight say as much, from 1 to kHypotheses: the inverse of the sum
  /// of the squared weights (Kong et al. 1994).
  double effectiveCount() const { return effective_count_; }

 private:
  static constexpr int kBytes = kHypotheses / 8;

  double effective_count_ = 0.0;
  std::array<std::array<double, 256>, kBytes> shares_{};  ///< of the values of each byte of a mask
};

}  // namespace smore
