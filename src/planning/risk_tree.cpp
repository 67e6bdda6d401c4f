// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_tree.h"

#include <algorithm>
#include <limits>

namespace smore {
namespace {

constexpr float kPartialStep = 0.3F;
constexpr double kShortestPart = 0.1;  // of a step; shorter ones crowd the tree

}  // namespace

int RiskTree::add(const RiskState& state, int parent) {
  states_.push_back(state);
  parents_.push_back(parent);
  return size() - 1;
}

int RiskTree::nearest(const RiskState& target) const {
  int best = 0;
  float best_distance = std::numeric_limits<float>::max();
  for (int i = 0; i < size(); ++i) {
    const float distance = motions_->squaredDistance(states_[i], target);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = i;
  }
  return best;
}

RiskTree::Extension RiskTree::extend(const RiskState& target, int limit) {
  const int parent = nearest(target);
  const RiskState from = states_[parent];
  const double distance = motions_->distance(from, target);
  const bool reaches = distance <= step_;
  const RiskState to =
      reaches ? target : interpolate(from, target, static_cast<float>(step_ / distance));
  if (motions_->within(from, to, limit)) {
    return {reaches ? Growth::kReached : Growth::kStep, add(to, parent)};
  }
  const RiskState part = interpolate(from, to, kPartialStep);
  if (motions_->distance(from, part) < kShortestPart * step_) return {};
  if (!motions_->within(from, part, limit)) return {};
  return {Growth::kStep, add(part, parent)};
}

std::vector<RiskState> RiskTree::branch(int node) const {
  std::vector<RiskState> states;
  for (; node >= 0; node = parents_[node]) states.push_back(states_[node]);
  std::reverse(states.begin(), states.end());
  return states;
}

}  // namespace smore
