// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "mapping_parameters.h"
#include "smore/ros/belief_files.h"
#include "smore/ros/map_keeper.h"

namespace smore {

/// The keeper of a mapping node: it has taken what there is to go on from, which is sought before a
/// journal of its own is begun, and writes that journal. InputError where either cannot be.
std::unique_ptr<MapKeeper> startKeeper(const MappingParameters& parameters,
                                       const EvidenceSource& source, const BeliefFiles& files);

}  // namespace smore
