// SPDX-License-Identifier: BSD-3-Clause
#include "other_task.h"

#include <algorithm>
#include <vector>

#include "scenario_priors.h"
#include "smore/scenario/scenario_files.h"

namespace smore {

void changeTask(const std::string& scenario, EvidenceSource* source) {
  source->task = loadScenario(findScenario(scenario, shippedScenarioDirectory()));
  source->priors = priorsOf(source->task, source->seed);
}

std::size_t leaveOutBesideThePlane(Evidence* evidence) {
  const MotionSpace space = evidence->source.task.motionSpace();
  std::vector<ContactObservation>& all = evidence->observations;
  const auto kept = std::remove_if(all.begin(), all.end(), [&space](const auto& observation) {
    return space.isBeside(observation.T_world_object);
  });
  const auto left_out = static_cast<std::size_t>(all.end() - kept);
  all.erase(kept, all.end());
  return left_out;
}

}  // namespace smore
