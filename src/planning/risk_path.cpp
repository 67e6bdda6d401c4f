// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_path.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// A move turns by as much as it shifts, in the metric of the search.
constexpr double kTurnShare = 1.0;

// Worlds that would let pass a path against which all worlds speak: keeps its cost finite.
constexpr double kLeastHope = 1e-6;

}  // namespace

RiskPath::RiskPath(const RiskMotions& motions, const RiskObjective& objective,
                   std::vector<RiskState> states)
    : motions_(&motions), objective_(objective), states_(std::move(states)) {
  for (std::size_t i = 1; i < states_.size(); ++i) {
    costs_.push_back(motions_->cost(states_[i - 1], states_[i]));
  }
  evaluate();
}

void RiskPath::evaluate() {
  value_ = valueOf(costs_);
  touching_ = 0;
  for (const MotionCost& cost : costs_) touching_ |= cost.touching;
}

double RiskPath::valueOf(const std::vector<MotionCost>& costs) const {
  std::array<float, kHypotheses> touching_length{};
  double length = 0.0;
  for (const MotionCost& cost : costs) {
    length += cost.length;
    if (cost.touching == 0) continue;
    for (int m = 0; m < kHypotheses; ++m) touching_length[m] += cost.touching_length[m];
  }
  double passing = kLeastHope;
  for (const float touched : touching_length) passing += std::exp(-touched / objective_.give);
  return length - objective_.touch_cost * std::log(passing / kHypotheses);
}

void RiskPath::improve(const RiskSpace& space, int attempts, double distance,
                       CounterRandom* random) {
  for (int i = 0; i < attempts && states_.size() > 2; ++i) tryShortcut(random);
  for (int i = 0; i < attempts && states_.size() > 2; ++i) tryMove(space, distance, random);
}

bool RiskPath::tryShortcut(CounterRandom* random) {
  int i = random->index(static_cast<int>(states_.size()));
  int j = random->index(static_cast<int>(states_.size()));
  if (i > j) std::swap(i, j);
  if (j - i < 2) return false;
  std::vector<MotionCost> costs(costs_.begin(), costs_.begin() + i);
  costs.push_back(motions_->cost(states_[i], states_[j]));
  costs.insert(costs.end(), costs_.begin() + j, costs_.end());
  if (valueOf(costs) > value_) return false;
  states_.erase(states_.begin() + i + 1, states_.begin() + j);
  costs_ = std::move(costs);
  evaluate();
  return true;
}

bool RiskPath::tryMove(const RiskSpace& space, double distance, CounterRandom* random) {
  const int i = 1 + random->index(static_cast<int>(states_.size()) - 2);
  const RiskState moved =
      space.sampleNear(states_[i], distance, kTurnShare * distance / space.lever(), random);
  if (!space.contains(moved)) return false;
  std::vector<MotionCost> costs = costs_;
  costs[i - 1] = motions_->cost(states_[i - 1], moved);
  costs[i] = motions_->cost(moved, states_[i + 1]);
  if (valueOf(costs) >= value_) return false;
  states_[i] = moved;
  costs_ = std::move(costs);
  evaluate();
  return true;
}

}  // namespace smore
