// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/method.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "smore/common/result.h"
#include "smore/mapping/joint_belief.h"
#include "smore/mapping/sequential_belief.h"
#include "smore/planning/blocked_movements.h"
#include "smore/planning/collision_hypotheses.h"
#include "smore/planning/cspace_memory.h"
#include "smore/planning/cspace_planner.h"
#include "smore/planning/map_planner.h"
#include "smore/planning/movement_planner.h"
#include "smore/planning/occupied_voxels.h"
#include "smore/planning/risk_planner.h"
#include "smore/retrieval/informed_touches.h"

namespace smore {
namespace {

// Planners count their calls up from their seed: trials whose seeds are neighbours must not share
// random numbers. No trial makes so many plans.
std::uint32_t plannerSeed(std::uint64_t seed) {
  constexpr std::uint64_t kMorePlansThanAnyTrial = 1000003;
  return static_cast<std::uint32_t>(seed * kMorePlansThanAnyTrial);
}

std::unique_ptr<TwinMap> makeSequentialBelief(const Scenario& scenario,
                                              SequentialBeliefParameters parameters = {}) {
  parameters.voxel_size = scenario.voxel_size;
  return std::make_unique<SequentialBelief>(parameters);
}

std::unique_ptr<JointBelief> makeJointBelief(const Scenario& scenario, std::uint64_t seed,
                                             JointBeliefParameters parameters,
                                             const Priors& priors) {
  parameters.voxel_size = scenario.voxel_size;
  if (scenario.motion == Motion::kPlanar) parameters.T_world_plane = scenario.start;
  parameters.seed = seed;
  auto belief = std::make_unique<JointBelief>(parameters);
  for (const Prior& prior : priors.object) belief->know(MapSide::kObject, prior);
  for (const Prior& prior : priors.world) belief->know(MapSide::kWorld, prior);
  return belief;
}

// The planner's step is the paper's: one voxel.
PathPlannerParameters pathParameters(const Scenario& scenario) {
  PathPlannerParameters parameters;
  parameters.step = scenario.voxel_size;
  return parameters;
}

Method makePaper(const Scenario& scenario, std::uint64_t seed, const PaperParameters& told) {
  Method method;
  method.maps = makeSequentialBelief(scenario, told.belief);
  MapPlannerParameters parameters;
  parameters.path = pathParameters(scenario);
  parameters.path.step *= told.step_in_voxels;
  // As the paper has it: RRT in the plane, RRT-Connect in space (its figure 8).
  if (scenario.motion == Motion::kSpatial) {
    parameters.path.algorithm = PlannerAlgorithm::kRrtConnect;
  }
  method.planner = std::make_unique<MapPlanner>(*method.maps, scenario.motionSpace(), parameters,
                                                plannerSeed(seed));
  method.touches = std::make_unique<RandomTouches>(scenario.motionSpace(), seed);
  return method;
}

Method makeCspace(const Scenario& scenario, std::uint64_t seed) {
  Method method;
  method.maps = makeSequentialBelief(scenario);
  auto memory = std::make_unique<CspaceMemory>();
  method.planner = std::make_unique<CspacePlanner>(*memory, scenario.motionSpace(),
                                                   pathParameters(scenario), plannerSeed(seed));
  method.memory = std::move(memory);
  method.touches = std::make_unique<RandomTouches>(scenario.motionSpace(), seed);
  return method;
}

// A tree that has not reached the goal by so many samples is given up for one at a higher limit.
constexpr int kSamplesPerLimit = 4000;

// What learns from movements, and the planner that asks it.
template <typename Memory>
Method makeMovementMethod(const Scenario& scenario, std::uint64_t seed,
                          std::unique_ptr<Memory> memory) {
  Method method;
  method.maps = makeSequentialBelief(scenario);
  MovementPlannerParameters parameters;
  parameters.path = pathParameters(scenario);
  parameters.path.max_iterations = kSamplesPerLimit;
  method.planner = std::make_unique<MovementPlanner>(*memory, scenario.motionSpace(), parameters,
                                                     plannerSeed(seed));
  method.memory = std::move(memory);
  method.touches = std::make_unique<RandomTouches>(scenario.motionSpace(), seed);
  return method;
}

Method makeBlocked(const Scenario& scenario, std::uint64_t seed) {
  return makeMovementMethod(scenario, seed, std::make_unique<BlockedMovements>());
}

Method makeChs(const Scenario& scenario, std::uint64_t seed, const Priors& priors) {
  return makeMovementMethod(
      scenario, seed,
      std::make_unique<CollisionHypotheses>(priors.object, scenario.motion == Motion::kPlanar));
}

Method makeSmore(const Scenario& scenario, std::uint64_t seed, const MethodParameters& parameters,
                 const Priors& priors) {
  Method method;
  auto belief = makeJointBelief(scenario, seed, parameters.belief, priors);
  method.planner =
      std::make_unique<RiskPlanner>(*belief, scenario.motionSpace(), parameters.planner, seed);
  method.maps = std::move(belief);
  if (scenario.motion == Motion::kPlanar) {
    method.touches = makeInformedTouches(method, scenario, seed);
  } else {
    method.touches = std::make_unique<RandomTouches>(scenario.motionSpace(), seed);
  }
  return method;
}

}  // namespace

std::unique_ptr<TouchPlanner> makeInformedTouches(const Method& method, const Scenario& scenario,
                                                  std::uint64_t seed) {
  return std::make_unique<InformedTouches>(dynamic_cast<const JointBelief&>(*method.maps),
                                           scenario.motionSpace(), InformedTouchParameters{}, seed);
}

void checkPriors(MethodKind kind, const Priors& priors) {
  if (kind == MethodKind::kSmore) return;
  if (kind == MethodKind::kChs) {
    const auto is_empty = [](const Prior& piece) {
      return occupiedVoxels(piece.known).keys.empty();
    };
    const std::vector<Prior>& object = priors.object;
    if (!object.empty() && std::all_of(object.begin(), object.end(), is_empty)) {
      throw InputError(
          "prior: what is told of the object holds no matter, only free space; look at min and "
          "max of its sources");
    }
    if (!object.empty() && priors.world.empty()) return;
    throw InputError(
        "prior: the method chs must be told the object's shape and nothing of the world; give "
        "prior: {object: [{source: truth}]} in the scenario, or use another method");
  }
  if (priors.empty()) return;
  throw InputError("prior: the method " + methodName(kind) +
                   " cannot use what is known beforehand; use smore, or leave the key out");
}

std::unique_ptr<TwinMap> makeTwinMap(MethodKind kind, const Scenario& scenario, std::uint64_t seed,
                                     const MethodParameters& parameters, const Priors& priors) {
  checkPriors(kind, priors);
  if (kind == MethodKind::kSmore) return makeJointBelief(scenario, seed, parameters.belief, priors);
  return makeSequentialBelief(scenario, parameters.paper.belief);
}

Method makeMethod(MethodKind kind, const Scenario& scenario, std::uint64_t seed,
                  const MethodParameters& parameters, const Priors& priors) {
  checkPriors(kind, priors);
  switch (kind) {
    case MethodKind::kPaper:
      return makePaper(scenario, seed, parameters.paper);
    case MethodKind::kCspace:
      return makeCspace(scenario, seed);
    case MethodKind::kSmore:
      return makeSmore(scenario, seed, parameters, priors);
    case MethodKind::kBlocked:
      return makeBlocked(scenario, seed);
    case MethodKind::kChs:
      return makeChs(scenario, seed, priors);
  }
  throw InputError("unknown method");
}

}  // namespace smore
