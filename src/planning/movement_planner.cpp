// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/movement_planner.h"

#include <algorithm>
#include <stdexcept>

#include "smore/mapping/counter_random.h"

namespace smore {

MovementPlanner::MovementPlanner(const MovementBelief& belief, const MotionSpace& space,
                                 const MovementPlannerParameters& parameters, std::uint32_t seed)
    : belief_(belief), space_(space), parameters_(parameters), seed_(seed) {
  const std::vector<double>& limits = parameters.limits;
  const bool sound = parameters.trees >= 1 && !limits.empty() && limits.front() >= 0.0 &&
                     limits.back() == 1.0 && std::is_sorted(limits.begin(), limits.end());
  if (!sound) throw std::invalid_argument("trees or limits of a movement planner out of range");
  const PathPlanner checks_the_rest(space, parameters.path, seed);
}

Result<Plan> MovementPlanner::plan(const Pose& start, const Pose& goal) {
  const std::uint32_t call = seed_++;
  const auto seed_of = [call](int tree) {
    return static_cast<std::uint32_t>(mixBits(call, static_cast<std::uint64_t>(tree)));
  };
  const auto grow = [&](std::size_t limit, int tree) {
    return growTree(start, goal, parameters_.limits[limit], seed_of(tree));
  };
  Result<Plan> best = grow(limit_, 0);
  while (best && limit_ > 0) {
    Result<Plan> safer = grow(limit_ - 1, 0);
    if (!safer) break;
    best = std::move(safer);
    --limit_;
  }
  while (!best && limit_ + 1 < parameters_.limits.size()) best = grow(++limit_, 0);
  for (int tree = 1; best && tree < parameters_.trees; ++tree) {
    Result<Plan> other = grow(limit_, tree);
    if (other && other->risk < best->risk) best = std::move(other);
  }
  return best;
}

Result<Plan> MovementPlanner::growTree(const Pose& start, const Pose& goal, double limit,
                                       std::uint32_t seed) const {
  PathPlanner planner(space_, parameters_.path, seed);
  planner.keepTree(keep_tree_);
  const auto path = planner.plan(
      start, goal, [](const Pose& /*pose*/) { return true; },
      [&](const Pose& from, const Pose& to) {
        return 1.0 - belief_.success({from, to}) <= limit;
      });
  if (!path) return Failure{path.reason()};
  return Plan{*path, 1.0 - belief_.success(*path), planner.tree()};
}

}  // namespace smore
