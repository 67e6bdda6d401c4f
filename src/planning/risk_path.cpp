// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_path.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// One of so many changes is a shortcut.
constexpr int kChangesPerShortcut = 3;

// Moves: of one state alone, along one axis alone; sizes are log-uniform between two multiples of
// the distance that is asked for.
constexpr double kAloneShare = 0.5;
constexpr double kAxisShare = 0.5;
constexpr double kSmallestMove = 0.2;
constexpr double kSizesOfMoves = 20.0;

}  // namespace

RiskPath::RiskPath(const RiskMotions& motions, const PathValue& measure,
                   std::vector<RiskState> states)
    : motions_(&motions), measure_(measure), states_(std::move(states)) {
  for (std::size_t i = 1; i < states_.size(); ++i) {
    costs_.push_back(motions_->cost(states_[i - 1], states_[i]));
    total_ += costs_.back();
  }
  value_ = measure_.along(states_).of(total_);
}

void RiskPath::improve(const RiskSpace& space, int attempts, double distance,
                       const Deadline& deadline, CounterRandom* random) {
  for (int i = 0; i < attempts && states_.size() > 2 && !deadline.passed(); ++i) {
    i % kChangesPerShortcut == 0 ? tryShortcut(random) : tryMove(space, distance, random);
  }
}

void RiskPath::tryShortcut(CounterRandom* random) {
  int i = random->index(static_cast<int>(states_.size()));
  int j = random->index(static_cast<int>(states_.size()));
  if (i > j) std::swap(i, j);
  if (j - i >= 2) replace(i, j, {});
}

void RiskPath::tryMove(const RiskSpace& space, double distance, CounterRandom* random) {
  const int inner = static_cast<int>(states_.size()) - 2;
  int first = 1 + random->index(inner);
  int last = random->uniform() < kAloneShare ? first : 1 + random->index(inner);
  if (first > last) std::swap(first, last);
  const double size = kSmallestMove * distance * std::pow(kSizesOfMoves, random->uniform());
  const double angle = size / space.lever();  // as much as it shifts, in the metric of the search
  const RiskState& pivot = states_[first];
  const RiskState moved = random->uniform() < kAxisShare
                              ? space.sampleAlongAxis(pivot, size, angle, random)
                              : space.sampleNear(pivot, size, angle, random);
  const Eigen::Vector3f shift = moved.position - pivot.position;
  const Eigen::Quaternionf turn = moved.rotation * pivot.rotation.conjugate();
  std::vector<RiskState> row;
  for (int i = first; i <= last; ++i) {
    row.push_back({states_[i].position + shift, (turn * states_[i].rotation).normalized()});
    if (!space.contains(row.back())) return;
  }
  replace(first - 1, last + 1, row);
}

void RiskPath::replace(int first, int last, const std::vector<RiskState>& inner) {
  std::vector<RiskState> states(states_.begin(), states_.begin() + first + 1);
  states.insert(states.end(), inner.begin(), inner.end());
  states.insert(states.end(), states_.begin() + last, states_.end());
  MotionCost total;
  for (int i = 0; i < first; ++i) total += costs_[i];
  for (std::size_t i = last; i < costs_.size(); ++i) total += costs_[i];
  const PathValue::Along value = measure_.along(states);
  const auto hopeless = [&](const MotionCost& part) {
    MotionCost sum = total;
    return value.of(sum += part) > value_;
  };
  std::vector<MotionCost> costs;
  for (std::size_t i = first; i <= first + inner.size(); ++i) {
    const auto cost = motions_->costUnless(states[i], states[i + 1], hopeless);
    if (!cost) return;
    costs.push_back(*cost);
    total += *cost;
  }
  const double changed = value.of(total);
  if (changed > value_) return;
  const auto rest = costs_.erase(costs_.begin() + first, costs_.begin() + last);
  costs_.insert(rest, costs.begin(), costs.end());
  states_ = std::move(states);
  total_ = total;
  value_ = changed;
}

}  // namespace smore
