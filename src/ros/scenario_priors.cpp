// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_priors.h"

#include "smore/mapping/prior_maps.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

Priors priorsOf(const Scenario& scenario, std::uint64_t seed) {
  if (scenario.prior.empty()) return {};
  return makePriors(scenario.hasScene() ? perturbScenario(scenario, seed) : scenario);
}

}  // namespace smore
