// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "smore/planning/risk_motion.h"

namespace smore {

/// A tree of states that grows towards samples by motions within a limit of risk.
class RiskTree {
 public:
  enum class Growth { kNone, kStep, kReached };
  struct Extension {
    Growth growth = Growth::kNone;
    int node = 0;  ///< the new node; where there is none, meaningless
  };

  /// `step` [m]: longest edge. `motions` is a view.
  RiskTree(const RiskMotions& motions, double step) : motions_(&motions), step_(step) {}

  /// Adds a state below `parent` (-1: a root); returns its number.
  int add(const RiskState& state, int parent);

  int size() const { return static_cast<int>(states_.size()); }
  const RiskState& state(int node) const { return states_[node]; }

  /// The node above `node`; negative for a root.
  int parent(int node) const { return parents_[node]; }

  /// One step towards `target`. Where the whole step would be too risky, a part of it: in a narrow
  /// slot nothing longer fits.
  Extension extend(const RiskState& target, int limit);

  /// The states from the root to `node`.
  std::vector<RiskState> branch(int node) const;

 private:
  int nearest(const RiskState& target) const;

  const RiskMotions* motions_;
  double step_;
  std::vector<RiskState> states_;
  std::vector<int> parents_;
};

}  // namespace smore
