// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "smore/mapping/twin_map.h"
#include "smore/planning/collision_checker.h"
#include "smore/planning/path_planner.h"
#include "smore/planning/planner.h"

namespace smore {

enum class CollisionBackend {
  kFcl,   ///< FclCollisionChecker
  kGrid,  ///< GridCollisionChecker: the same answers, faster
};

struct MapPlannerParameters {
  PathPlannerParameters path;
  CollisionBackend backend = CollisionBackend::kFcl;
  /// Probabilities above 0.5 from which a relaxed plan takes voxels for occupied, tried in this
  /// order.
  std::vector<double> relaxed_thresholds = {0.7, 0.9, 0.99, 1.0};
  double overlap_share = 0.045;  ///< deepest overlap of voxels on a path, as a share of their size,
                                 ///< in (0, 1): 5 % is the promise, the rest is margin for rounding
};

/// The paper's planner: a pose is valid where no voxel with P >= 0.5 of one map overlaps one of the
/// other (paper, III-C); unknown space is free.
///
/// The maps may say that voxels overlap at the start, where the object in fact stands free. Then
/// the plan is made with the most probable voxels that allow it to stand there (voxelsGivenFree):
/// the maps stay as they are, and the start is never the reason why there is no plan.
class MapPlanner : public Planner {
 public:
  /// `map` must outlive the planner. Search i (from 0) draws its samples from `seed` + i;
  /// a relaxed plan takes several.
  /// std::invalid_argument for parameters out of their ranges.
  MapPlanner(const TwinMap& map, const MotionSpace& space, const MapPlannerParameters& parameters,
             std::uint32_t seed);

  /// `start` is where the object stands now, free of contact. The risk of the plan is 0: by these
  /// maps every pose is either free or not.
  Result<Plan> plan(const Pose& start, const Pose& goal) override;

  /// The paper does not say what to do when the maps wall the object in, as they do at times: they
  /// are wrong then, since there is a way out. Here the voxels count as occupied only from a higher
  /// probability on, raised until there is a path.
  Result<Plan> planRelaxed(const Pose& start, const Pose& goal) override;

 private:
  Result<Plan> planFrom(double threshold, const Pose& start, const Pose& goal);
  std::unique_ptr<CollisionChecker> makeChecker(double threshold, const Pose& known_free) const;

  const TwinMap& map_;
  MotionSpace space_;
  MapPlannerParameters parameters_;
  std::uint32_t seed_;
};

}  // namespace smore
