// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/path_value.h"

#include <cmath>

namespace smore {
namespace {

// Worlds that would let pass a path against which all worlds speak: keeps its cost finite.
constexpr double kLeastHope = 1e-6;

}  // namespace

PathValue::Along PathValue::along(const std::vector<RiskState>& states) const {
  Along result;
  result.objective_ = objective_;
  result.no_surprise_.fill(1.0);
  if (room_ == nullptr) return result;
  result.no_surprise_ = room_->noSurpriseAlong(states);
  for (double& share : result.no_surprise_) share = std::pow(share, surprises_);
  return result;
}

double PathValue::Along::of(const MotionCost& total) const {
  double hope = kLeastHope;
  for (int m = 0; m < kHypotheses; ++m) {
    hope += no_surprise_[m] * std::exp(-total.touching_length[m] / objective_.give);
  }
  return total.length - objective_.touch_cost * std::log(hope / kHypotheses);
}

}  // namespace smore
