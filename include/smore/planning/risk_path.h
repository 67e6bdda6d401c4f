// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/common/deadline.h"
#include "smore/mapping/counter_random.h"
#include "smore/planning/path_value.h"
#include "smore/planning/risk_motion.h"
#include "smore/planning/risk_space.h"

namespace smore {

/// A path with the costs of its motions, so that a change costs only what it changes.
class RiskPath {
 public:
  /// At least two states. `motions` is a view, as is the room of `measure`.
  RiskPath(const RiskMotions& motions, const PathValue& measure, std::vector<RiskState> states);

  const std::vector<RiskState>& states() const { return states_; }
  double value() const { return value_; }  ///< J, smaller is better

  /// Tries `attempts` random changes in `space`, each from a fifth of `distance` [m] to four times
  /// as much: shortcuts, and moves of inner states, of one or of several in a row together, as a
  /// slot needs that is left in the posture in which it was entered. What makes J smaller stays.
  /// Ends early at the deadline.
  void improve(const RiskSpace& space, int attempts, double distance, const Deadline& deadline,
               CounterRandom* random);

 private:
  void tryShortcut(CounterRandom* random);
  void tryMove(const RiskSpace& space, double distance, CounterRandom* random);
  /// Puts `inner` between the states `first` and `last`, unless that makes J larger.
  void replace(int first, int last, const std::vector<RiskState>& inner);

  const RiskMotions* motions_;
  PathValue measure_;
  std::vector<RiskState> states_;
  std::vector<MotionCost> costs_;  ///< of the motion to each state but the first
  MotionCost total_;
  double value_ = 0.0;
};

/// Whether path a is to be taken rather than b.
inline bool isBetter(const RiskPath& a, const RiskPath& b) { return a.value() < b.value(); }

}  // namespace smore
