// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/method.h"

#include <utility>

#include "smore/common/result.h"
#include "smore/mapping/joint_belief.h"
#include "smore/mapping/sequential_belief.h"
#include "smore/planning/cspace_memory.h"
#include "smore/planning/cspace_planner.h"
#include "smore/planning/map_planner.h"
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

std::unique_ptr<TwinMap> makeSequentialBelief(const Scenario& scenario) {
  SequentialBeliefParameters parameters;
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

void refusePriors(MethodKind kind, const Priors& priors) {
  if (priors.empty()) return;
  throw InputError("prior: the method " + methodName(kind) +
                   " cannot use what is known beforehand; use smore, or leave the key out");
}

// The planner's step is the paper's: one voxel.
PathPlannerParameters pathParameters(const Scenario& scenario) {
  PathPlannerParameters parameters;
  parameters.step = scenario.voxel_size;
  return parameters;
}

Method makePaper(const Scenario& scenario, std::uint64_t seed) {
  Method method;
  method.maps = makeSequentialBelief(scenario);
  MapPlannerParameters parameters;
  parameters.path = pathParameters(scenario);
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

Method makeSmore(const Scenario& scenario, std::uint64_t seed, const MethodParameters& parameters,
                 const Priors& priors) {
  Method method;
  auto belief = makeJointBelief(scenario, seed, parameters.belief, priors);
  method.planner =
      std::make_unique<RiskPlanner>(*belief, scenario.motionSpace(), parameters.planner, seed);
  method.touches = std::make_unique<InformedTouches>(*belief, scenario.motionSpace(),
                                                     InformedTouchParameters{}, seed);
  method.maps = std::move(belief);
  return method;
}

}  // namespace

MethodKind methodKind(const std::string& name) {
  for (const MethodKind kind : {MethodKind::kPaper, MethodKind::kCspace, MethodKind::kSmore}) {
    if (methodName(kind) == name) return kind;
  }
  throw InputError("unknown method '" + name + "'; use paper, cspace or smore");
}

std::vector<std::string> methodNames() {
  return {methodName(MethodKind::kPaper), methodName(MethodKind::kCspace),
          methodName(MethodKind::kSmore)};
}

std::string methodName(MethodKind kind) {
  switch (kind) {
    case MethodKind::kPaper:
      return "paper";
    case MethodKind::kCspace:
      return "cspace";
    case MethodKind::kSmore:
      return "smore";
  }
  return "unknown";
}

std::unique_ptr<TwinMap> makeTwinMap(MethodKind kind, const Scenario& scenario, std::uint64_t seed,
                                     const JointBeliefParameters& parameters,
                                     const Priors& priors) {
  if (kind == MethodKind::kSmore) return makeJointBelief(scenario, seed, parameters, priors);
  refusePriors(kind, priors);
  return makeSequentialBelief(scenario);
}

Method makeMethod(MethodKind kind, const Scenario& scenario, std::uint64_t seed,
                  const MethodParameters& parameters, const Priors& priors) {
  if (kind != MethodKind::kSmore) refusePriors(kind, priors);
  switch (kind) {
    case MethodKind::kPaper:
      return makePaper(scenario, seed);
    case MethodKind::kCspace:
      return makeCspace(scenario, seed);
    case MethodKind::kSmore:
      return makeSmore(scenario, seed, parameters, priors);
  }
  throw InputError("unknown method");
}

}  // namespace smore
