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

HypothesisWeights::Founders allFounders() {
  HypothesisWeights::Founders founders{};
  std::iota(founders.begin(), founders.end(), 0);
  return founders;
}

}  // namespace

HypothesisWeights::HypothesisWeights() : HypothesisWeights(equalWeights(), allFounders()) {}

HypothesisWeights::HypothesisWeights(const Weights& weights, const Founders& founders) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (int byte = 0; byte < kBytes; ++byte) {
    for (unsigned value = 1; value < 256; ++value) {
      const int lowest = __builtin_ctz(value);
      shares_[byte][value] = shares_[byte][value & (value - 1)] + weights[8 * byte + lowest] / sum;
    }
  }
  Weights of_founder{};
  for (int m = 0; m < kHypotheses; ++m) of_founder[founders[m]] += weights[m] / sum;
  effective_count_ =
      1.0 / std::inner_product(of_founder.begin(), of_founder.end(), of_founder.begin(), 0.0);
}

}  // namespace smore
