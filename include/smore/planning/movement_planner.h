// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "smore/planning/movement_belief.h"
#include "smore/planning/path_planner.h"
#include "smore/planning/planner.h"

namespace smore {

struct MovementPlannerParameters {
  PathPlannerParameters path;
  /// Probabilities of failure that one movement may have, ascending; the last one is 1, so that
  /// there is a path.
  std::vector<double> limits = {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9, 1.0};
  int trees = 4;  ///< grown at the first limit that has a path; the best is taken, at least 1
};

/// A probabilistic RRT: its edges are movements whose probability of failure stays below a limit,
/// the least one at which a tree reaches the goal, so that doubtful places are passed only where
/// there is no other way, and then the least doubtful ones. Of several trees within that limit the
/// path with the least probability of failure as a whole is taken.
class MovementPlanner : public Planner {
 public:
  /// `belief` must outlive the planner. Call i (from 0) draws all its chances from `seed` + i.
  /// std::invalid_argument for parameters out of their ranges.
  MovementPlanner(const MovementBelief& belief, const MotionSpace& space,
                  const MovementPlannerParameters& parameters, std::uint32_t seed);

  /// The risk is the probability that the path fails, by the belief. Fails where start or goal lie
  /// outside of the workspace, or no tree finds the goal.
  Result<Plan> plan(const Pose& start, const Pose& goal) override;

 private:
  Result<Plan> growTree(const Pose& start, const Pose& goal, double limit,
                        std::uint32_t seed) const;

  const MovementBelief& belief_;
  MotionSpace space_;
  MovementPlannerParameters parameters_;
  std::uint32_t seed_;
  std::size_t limit_ = 0;  ///< that of the last plan, where the next search begins
};

}  // namespace smore
