// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/path_value.h"

#include <cmath>

namespace smore {
namespace {

// Worlds that would let pass a path against which all worlds speak: keeps its cost finite.
constexpr double kLeastHope = 1e-6;

SweptRoom::Shares certain() {
  SweptRoom::Shares shares;
  shares.fill(1.0);
  return shares;
}

}  // namespace

double PathValue::of(const std::vector<RiskState>& states, const MotionCost& total) const {
  if (room_ == nullptr) return atLeast(total);
  SweptRoom::Shares shares = room_->noSurpriseAlong(states);
  for (double& share : shares) share = std::pow(share, objective_.surprises);
  return ofHope(total, shares);
}

double PathValue::atLeast(const MotionCost& part) const { return ofHope(part, certain()); }

double PathValue::ofHope(const MotionCost& total, const SweptRoom::Shares& shares) const {
  double hope = kLeastHope;
  for (int m = 0; m < kHypotheses; ++m) {
    hope += shares[m] * std::exp(-total.touching_length[m] / objective_.give);
  }
  return total.length - objective_.touch_cost * std::log(hope / kHypotheses);
}

}  // namespace smore
