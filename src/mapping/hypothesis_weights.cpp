// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/hypothesis_weights.h"

#include <numeric>

namespace smore {
namespace {

HypothesisWeights::Weights equalWeights() {
  HypothesisWeights::Weights weights{};
  weights.fill(1.0);
  return weights;
}

}  // namespace

HypothesisWeights::HypothesisWeights() : HypothesisWeights(equalWeights()) {}

HypothesisWeights::HypothesisWeights(const Weights& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (int byte = 0; byte < kBytes; ++byte) {
    for (unsigned value = 1; value < 256; ++value) {
      const int lowest = __builtin_ctz(value);
      shares_[byte][value] = shares_[byte][value & (value - 1)] + weights[8 * byte + lowest] / sum;
    }
  }
  effective_count_ =
      sum * sum / std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

}  // namespace smore
