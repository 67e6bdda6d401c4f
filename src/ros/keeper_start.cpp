// SPDX-License-Identifier: BSD-3-Clause
#include "keeper_start.h"

#include <ros/ros.h>

namespace smore {
namespace {

std::unique_ptr<EvidenceJournal> makeJournal(const MappingParameters& parameters,
                                             const EvidenceSource& source) {
  const auto directory = journalOf(parameters);
  if (!directory) return nullptr;
  return std::make_unique<EvidenceJournal>(*directory, source);
}

}  // namespace

std::unique_ptr<MapKeeper> startKeeper(const MappingParameters& parameters,
                                       const EvidenceSource& source, const BeliefFiles& files) {
  const auto earlier = earlierEvidence(parameters);
  auto keeper = std::make_unique<MapKeeper>(
      [source](const Priors& priors) {
        return makeTwinMap(source.method, source.task, source.seed, source.parameters, priors);
      },
      spacingFor(source.task), makeJournal(parameters, source), source.priors);
  if (earlier) ROS_INFO_STREAM(files.loadFrom(*earlier, keeper.get()));
  return keeper;
}

}  // namespace smore
