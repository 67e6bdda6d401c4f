// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/path_value.h"

#include <algorithm>
#include <cmath>

namespace smore {

PathValue::Along PathValue::along(const std::vector<RiskState>& states) const {
  Along result;
  result.objective_ = objective_;
  if (room_ == nullptr) return result;
  const SweptRoom::Shares shares = room_->noSurpriseAlong(states);
  for (int m = 0; m < kHypotheses; ++m) {
    result.log_no_surprise_[m] = surprises_ * std::log(shares[m]);
  }
  return result;
}

// By logarithms: where all worlds speak against a path by hundreds of nats, some do so by less.
double PathValue::Along::of(const MotionCost& total) const {
  std::array<double, kHypotheses> log_hopes = log_no_surprise_;
  for (int m = 0; m < kHypotheses; ++m) log_hopes[m] -= total.touching_length[m] / objective_.give;
  const double best = *std::max_element(log_hopes.begin(), log_hopes.end());
  double sum = 0.0;
  for (const double log_hope : log_hopes) sum += std::exp(log_hope - best);
  return total.length - objective_.touch_cost * (best + std::log(sum / kHypotheses));
}

}  // namespace smore
