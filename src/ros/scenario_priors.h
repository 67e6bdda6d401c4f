// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "smore/mapping/prior.h"
#include "smore/retrieval/evidence.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// What the scenario says to be known beforehand; the truth is that of the simulator with this
/// seed. InputError as of makePriors.
Priors priorsOf(const Scenario& scenario, std::uint64_t seed);

/// Another task for recorded observations, with what it says to be known beforehand. `scenario`: a
/// shipped name or a file. InputError where it cannot be read or used.
void changeTask(const std::string& scenario, EvidenceSource* source);

/// Leaves out the observations that lie beside the plane of a planar task (EvidenceSpacing); how
/// many these were.
std::size_t leaveOutBesideThePlane(Evidence* evidence);

}  // namespace smore
