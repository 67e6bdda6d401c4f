// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/belief_parameters.h"

namespace smore {

/// The unit of length of the small scenes of the tests [m].
constexpr double kDecimetre = 0.1;

/// The default parameters at this unit.
inline JointBeliefParameters atADecimetre() { return inMetres({}, kDecimetre, kDecimetre); }

}  // namespace smore
