// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/result.h"
#include "smore/planning/planner.h"
#include "smore/scenario/motion_space.h"

namespace smore {

enum class PlannerAlgorithm { kRrt, kRrtConnect };

struct PathPlannerParameters {
  PlannerAlgorithm algorithm = PlannerAlgorithm::kRrt;
  double step = 0.03;  ///< longest edge of the tree [m + rad], positive; the paper's voxel size
  double goal_bias = 0.05;     ///< share of samples that are the goal, in [0, 1] (RRT only)
  int max_iterations = 20000;  ///< samples before giving up, at least 1
  double time_limit_s = 60.0;  ///< wall time before giving up [s], positive
};

/// One pose is valid or not. Called often; must be safe to call again with the same pose.
using StateValidity = std::function<bool(const Pose& T_world_object)>;

/// All poses of the motion from one valid pose to another (as `interpolate` moves) are valid or
/// not.
using MotionValidity = std::function<bool(const Pose& from, const Pose& to)>;

/// How finely motions are checked: neighbouring checks are at most this far apart.
struct CheckResolution {
  double distance = 0.003;  ///< [m], positive
  double angle = 0.01;      ///< [rad], positive
};

/// Sampling planners of OMPL in SE(2) or SE(3), exact solutions only.
///
/// The same arguments and seed give the same path, on any number of threads, unless the time limit
/// ends the search. OMPL's own console output is switched off for the whole process.
class PathPlanner {
 public:
  /// `space` gives the states and their bounds (planar: the plane may be tilted in the world);
  /// `seed` makes runs repeatable. std::invalid_argument for parameters out of their ranges.
  PathPlanner(const MotionSpace& space, const PathPlannerParameters& parameters,
              std::uint32_t seed);

  /// A path from start to goal through valid poses, or the reason: start or goal invalid or out of
  /// bounds, iterations or time used up. The path begins exactly at `start` and ends exactly at
  /// `goal`. Motions are checked at poses no further apart than `resolution`.
  Result<Path> plan(const Pose& start, const Pose& goal, const StateValidity& valid,
                    const CheckResolution& resolution);

  /// The same with a motion check of the caller's own.
  Result<Path> plan(const Pose& start, const Pose& goal, const StateValidity& valid,
                    const MotionValidity& motion_valid);

  /// From now on `tree` holds what each search explores.
  void keepTree(bool keep) { keep_tree_ = keep; }
  const std::vector<TreeEdge>& tree() const { return tree_; }

 private:
  MotionSpace space_;
  PathPlannerParameters parameters_;
  std::uint32_t seed_;
  bool keep_tree_ = false;
  std::vector<TreeEdge> tree_;
};

}  // namespace smore
