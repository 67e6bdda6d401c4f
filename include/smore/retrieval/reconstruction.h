// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>

#include "smore/common/robot.h"
#include "smore/retrieval/retrieval.h"
#include "smore/retrieval/touch_planner.h"
#include "smore/scenario/scenario.h"

namespace smore {

struct ReconstructionParameters {
  Pose start = Pose::Identity();  ///< T_world_object
  OnContact on_contact = OnContact::kReset;
  double retreat_distance = 0.05;                        ///< [m + rad], positive
  int touches = 300;                                     ///< budget, at least 1
  int max_collisions = std::numeric_limits<int>::max();  ///< gives up after so many, at least 1
};

ReconstructionParameters reconstructionParameters(const Scenario& scenario);

/// Touches until the budget is used up, no further motion would tell enough, or the limit of
/// collisions is reached, which is no success; the maps are the result (paper, section III-D).
/// Motions that touch nothing are observations too, but not counted; after ten times the budget of
/// motions it ends all the same, and where the robot could not follow twenty in a row.
/// `should_stop` is asked before each motion and may be empty, `motions` null.
RetrievalOutcome reconstruct(const ReconstructionParameters& parameters, Robot* robot,
                             TouchPlanner* touches, const Retrieval::ProgressCallback& on_progress,
                             const std::function<bool()>& should_stop,
                             MotionObserver* motions = nullptr);

}  // namespace smore
