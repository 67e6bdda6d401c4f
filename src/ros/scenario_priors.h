// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "smore/mapping/prior.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// What the scenario says to be known beforehand; the truth is that of the simulator with this
/// seed. InputError as of makePriors.
Priors priorsOf(const Scenario& scenario, std::uint64_t seed);

}  // namespace smore
