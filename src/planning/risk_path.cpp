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
    total_ += costs_.back();
  }
  value_ = valueOf(total_);
}

double RiskPath::valueOf(const MotionCost& total) const {
  double passing = kLeastHope;
  for (const float touched : total.touching_length) passing += std::exp(-touched / objective_.give);
  return total.length - objective_.touch_cost * std::log(passing / kHypotheses);
}

void RiskPath::improve(const RiskSpace& space, int attempts, double distance,
                       const Deadline& deadline, CounterRandom* random) {
  for (int i = 0; i < 2 * attempts && states_.size() > 2 && !deadline.passed(); ++i) {
    i < attempts ? tryShortcut(random) : tryMove(space, distance, random);
  }
}

void RiskPath::tryShortcut(CounterRandom* random) {
  int i = random->index(static_cast<int>(states_.size()));
  int j = random->index(static_cast<int>(states_.size()));
  if (i > j) std::swap(i, j);
  if (j - i >= 2) replace(i, j, {});
}

void RiskPath::tryMove(const RiskSpace& space, double distance, CounterRandom* random) {
  const int i = 1 + random->index(static_cast<int>(states_.size()) - 2);
  const RiskState moved =
      space.sampleNear(states_[i], distance, kTurnShare * distance / space.lever(), random);
  if (space.contains(moved)) replace(i - 1, i + 1, {moved});
}

void RiskPath::replace(int first, int last, const std::vector<RiskState>& inner) {
  MotionCost total;
  for (int i = 0; i < first; ++i) total += costs_[i];
  for (std::size_t i = last; i < costs_.size(); ++i) total += costs_[i];
  const auto hopeless = [&](const MotionCost& part) {
    MotionCost sum = total;
    return valueOf(sum += part) > value_;
  };
  std::vector<RiskState> way = inner;
  way.push_back(states_[last]);
  std::vector<MotionCost> costs;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const auto cost = motions_->costUnless(i == 0 ? states_[first] : way[i - 1], way[i], hopeless);
    if (!cost) return;
    costs.push_back(*cost);
    total += *cost;
  }
  const auto rest = costs_.erase(costs_.begin() + first, costs_.begin() + last);
  costs_.insert(rest, costs.begin(), costs.end());
  states_.erase(states_.begin() + first + 1, states_.begin() + last);
  states_.insert(states_.begin() + first + 1, inner.begin(), inner.end());
  total_ = total;
  value_ = valueOf(total_);
}

}  // namespace smore
