// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/cspace_planner.h"

namespace smore {
namespace {

// Motions are checked at poses this share of the memory's radius apart, in metres and in radians: a
// motion can cut no deeper than this share into the ball around a contact.
constexpr double kCheckShare = 0.1;

}  // namespace

CspacePlanner::CspacePlanner(const CspaceMemory& memory, const MotionSpace& space,
                             const PathPlannerParameters& parameters, std::uint32_t seed)
    : memory_(memory), space_(space), parameters_(parameters), seed_(seed) {
  const PathPlanner checks_the_parameters(space, parameters, seed);
}

Result<Plan> CspacePlanner::plan(const Pose& start, const Pose& goal) {
  PathPlanner planner(space_, parameters_, seed_++);
  planner.keepTree(keep_tree_);
  const double spacing = kCheckShare * memory_.radius();
  const auto path = planner.plan(
      start, goal, [&](const Pose& pose) { return memory_.isValid(pose, start); },
      CheckResolution{spacing, spacing});
  if (!path) return Failure{path.reason()};
  return Plan{*path, 0.0, planner.tree()};
}

}  // namespace smore
