// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_priors.h"

#include "smore/mapping/prior_maps.h"
#include "smore/scenario/scenario_files.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

Priors priorsOf(const Scenario& scenario, std::uint64_t seed) {
  if (scenario.prior.empty()) return {};
  return makePriors(scenario.hasScene() ? perturbScenario(scenario, seed) : scenario);
}

void changeTask(const std::string& scenario, EvidenceSource* source) {
  source->task = loadScenario(findScenario(scenario, shippedScenarioDirectory()));
  source->priors = priorsOf(source->task, source->seed);
}

}  // namespace smore
