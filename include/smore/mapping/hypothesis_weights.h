// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "smore/mapping/mask_bricks.h"

namespace smore {

/// How likely each sampled explanation is, where they are not equally so.
class HypothesisWeights {
 public:
  using Weights = std::array<double, kHypotheses>;
  using Founders = std::array<int, kHypotheses>;

  /// All equal and independent.
  HypothesisWeights();

  /// `weights`: not negative, not all 0; of any sum. Hypotheses of one founder, a number from 0 to
  /// kHypotheses - 1, are not independent of one another (ExplanationSample).
  HypothesisWeights(const Weights& weights, const Founders& founders);

  /// Probability that one of the hypotheses in the mask is true; from 0 to 1.
  double shareOf(HypothesisMask mask) const {
    double share = 0.0;
    for (int byte = 0; byte < kBytes; ++byte) share += shares_[byte][(mask >> (8 * byte)) & 0xFF];
    return share;
  }

  /// As many hypotheses, equal and independent, would say what is likely with as small a variance,
  /// from 1 to kHypotheses: the inverse of the sum of squares of what each founder's weigh
  /// together. Descent is what the variance of a population that was resampled shows in (Chan and
  /// Lai, 2013, A general theory of particle filters in hidden Markov models), but for what was
  /// drawn anew since.
  double effectiveCount() const { return effective_count_; }

 private:
  static constexpr int kBytes = kHypotheses / 8;

  double effective_count_ = 0.0;
  std::array<std::array<double, 256>, kBytes> shares_{};  ///< of the values of each byte of a mask
};

}  // namespace smore
