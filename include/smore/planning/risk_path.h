// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/counter_random.h"
#include "smore/planning/risk_motion.h"
#include "smore/planning/risk_space.h"

namespace smore {

/// What a path is worth. In metres of motion:
///
///   J = length - touch_cost * log(1 - r) + exposure_cost * integral of the pose risk over the
///   length
///
/// with r the share of worlds in which the path touches anywhere, at most kMostRisk.
struct RiskObjective {
  double touch_cost = 3.0;     ///< what one nat of not arriving is worth in motion [m]
  double exposure_cost = 2.0;  ///< a metre at pose risk 1 costs so many metres more

  /// Keeps a path without hope finite, so that the search never runs out of paths to try.
  static constexpr double kMostRisk = 0.985;
};

/// A path with the costs of its motions, so that a change costs only what it changes.
class RiskPath {
 public:
  /// At least two states. `motions` is a view.
  RiskPath(const RiskMotions& motions, const RiskObjective& objective,
           std::vector<RiskState> states);

  const std::vector<RiskState>& states() const { return states_; }
  double value() const { return value_; }  ///< J, smaller is better
  double risk() const { return shareOf(touching_); }

  /// Tries `attempts` random shortcuts, then as many random moves of inner states in `space`, each
  /// within `distance` [m]; what makes J smaller stays.
  void improve(const RiskSpace& space, int attempts, double distance, CounterRandom* random);

 private:
  bool tryShortcut(CounterRandom* random);
  bool tryMove(const RiskSpace& space, double distance, CounterRandom* random);
  void evaluate();
  double valueOf(const std::vector<MotionCost>& costs, HypothesisMask* touching) const;

  const RiskMotions* motions_;
  RiskObjective objective_;
  std::vector<RiskState> states_;
  std::vector<MotionCost> costs_;  ///< of the motion to each state but the first
  HypothesisMask touching_ = 0;
  double value_ = 0.0;
};

}  // namespace smore
