// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/planning/risk_motion.h"
#include "smore/planning/swept_room.h"

namespace smore {

/// How a path is valued (PathValue); its lengths in one unit, that of the path's.
struct RiskObjective {
  double touch_cost = 200.0;  ///< what one nat of not arriving is worth in motion
  double give = 0.2;          ///< accuracy of what is known of matter's place
};

/// What a path is worth, as a length of motion:
///
///   J = length - touch_cost * log(mean over the worlds of s^surprises * exp(-touching length /
///   give))
///
/// A world's say against a path grows with the length on which the path touches in it: matter is
/// known only to some accuracy, so that a graze may well pass, and where every world objects, the
/// path with the least to go through is still told from a hopeless one. s is how likely it is that
/// the path meets no matter that nobody knows of, after one surprise (SweptRoom).
class PathValue {
 public:
  /// `room` is a view; where it is null, matter that nobody knows of is left out. `surprises` [at
  /// least 0]: how many touches so far came of such matter.
  PathValue(const RiskObjective& objective, const SweptRoom* room, double surprises)
      : objective_(objective), room_(room), surprises_(surprises) {}

  /// What paths through the same states are worth, by what they cost.
  class Along {
   public:
    /// J of a path that costs `total`, or the least that it can be where that is but a part.
    double of(const MotionCost& total) const;

   private:
    friend class PathValue;
    RiskObjective objective_;
    SweptRoom::Shares no_surprise_;  ///< s^surprises, by world
  };

  /// Of a path of at least one state: what does not hang on where it touches is found here, once.
  Along along(const std::vector<RiskState>& states) const;

 private:
  RiskObjective objective_;
  const SweptRoom* room_;
  double surprises_;
};

}  // namespace smore
