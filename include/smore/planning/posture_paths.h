// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "smore/planning/risk_path.h"

namespace smore {

/// Paths that take another posture, go on in it as the goal lies from the start, and take the
/// goal's posture there. A posture is a turn and a shift: half of the turns are quarter turns about
/// the map's axes, the coarsest that there are, the others uniform; small shifts are tried more
/// often than large ones. Trees that grow by small steps hardly ever find such ways in space.
class PosturePaths {
 public:
  /// `motions` is a view, as is the room of `measure`.
  PosturePaths(const RiskMotions& motions, const RiskSpace& space, const PathValue& measure);

  /// The `kept` best of `tried` random ones, best first; of fewer where the deadline passes. The
  /// same seed gives the same ones.
  std::vector<RiskPath> best(const RiskState& start, const RiskState& goal, int tried, int kept,
                             const Deadline& deadline, std::uint64_t seed) const;

 private:
  std::vector<RiskState> draw(const RiskState& start, const RiskState& goal,
                              CounterRandom* random) const;
  Eigen::Quaternionf turned(const RiskState& start, const RiskState& any,
                            CounterRandom* random) const;
  bool mayBeBelow(double limit, const std::vector<RiskState>& states) const;

  const RiskMotions* motions_;
  RiskSpace space_;
  PathValue measure_;
};

}  // namespace smore
