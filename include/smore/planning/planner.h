// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"
#include "smore/common/result.h"

namespace smore {

struct Plan {
  Path path;  ///< from the start to within the goal's tolerance
  double risk =
      0.0;  ///< probability that the motion touches, as far as the planner knows; in [0, 1]
};

/// Finds a motion by what has been learnt so far.
class Planner {
 public:
  virtual ~Planner() = default;

  /// A path from `start` to `goal` (T_world_object), or the reason why there is none.
  virtual Result<Plan> plan(const Pose& start, const Pose& goal) = 0;

  /// For when `plan` finds none although the object is known to have a way out: a path that passes
  /// what is least certainly occupied. Planners without such a notion fail with a reason.
  virtual Result<Plan> planRelaxed(const Pose& /*start*/, const Pose& /*goal*/) {
    return Failure{"this planner knows no path that is less certain"};
  }
};

}  // namespace smore
