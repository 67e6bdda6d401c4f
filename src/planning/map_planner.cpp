// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/map_planner.h"

#include <stdexcept>

#include "smore/mapping/octomap_export.h"
#include "smore/planning/fcl_collision_checker.h"
#include "smore/planning/free_pose_voxels.h"
#include "smore/planning/grid_collision_checker.h"

namespace smore {
namespace {

VoxelGrid atLeast(double threshold, const VoxelGrid& grid) {
  VoxelGrid kept(grid.voxelSize());
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if (voxel.probability >= threshold) kept.set(voxel.key, voxel.probability);
  }
  return kept;
}

}  // namespace

MapPlanner::MapPlanner(const TwinMap& map, const MotionSpace& space,
                       const MapPlannerParameters& parameters, std::uint32_t seed)
    : map_(map), space_(space), parameters_(parameters), seed_(seed) {
  if (!(parameters.overlap_share > 0.0 && parameters.overlap_share < 1.0)) {
    throw std::invalid_argument("the share of overlap must be between 0 and 1");
  }
  const PathPlanner checks_the_rest(space, parameters.path, seed);
}

Result<Plan> MapPlanner::plan(const Pose& start, const Pose& goal) {
  return planFrom(kOccupied, start, goal);
}

Result<Plan> MapPlanner::planRelaxed(const Pose& start, const Pose& goal) {
  Result<Plan> plan = Failure{"no thresholds to relax to"};
  for (const double threshold : parameters_.relaxed_thresholds) {
    plan = planFrom(threshold, start, goal);
    if (plan) break;
  }
  return plan;
}

Result<Plan> MapPlanner::planFrom(double threshold, const Pose& start, const Pose& goal) {
  const auto checker = makeChecker(threshold, start);
  const double depth = parameters_.overlap_share * checker->voxelSize();
  PathPlanner planner(space_, parameters_.path, seed_++);
  planner.keepTree(keep_tree_);
  const auto path = planner.plan(
      start, goal, [&checker](const Pose& pose) { return !checker->inCollision(pose); },
      [&checker, depth](const Pose& from, const Pose& to) {
        return isMotionFree(*checker, from, to, depth);
      });
  if (!path) return Failure{path.reason()};
  return Plan{*path, 0.0, planner.tree()};
}

std::unique_ptr<CollisionChecker> MapPlanner::makeChecker(double threshold,
                                                          const Pose& known_free) const {
  const TwinVoxels voxels = voxelsGivenFree(atLeast(threshold, map_.object()),
                                            atLeast(threshold, map_.world()), known_free);
  if (parameters_.backend == CollisionBackend::kGrid) {
    return std::make_unique<GridCollisionChecker>(voxels.object, voxels.world);
  }
  return std::make_unique<FclCollisionChecker>(voxels.object, voxels.world);
}

}  // namespace smore
