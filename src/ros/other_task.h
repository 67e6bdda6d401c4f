// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "smore/retrieval/evidence.h"

namespace smore {

/// Another task for recorded observations, with what it says to be known beforehand. `scenario`: a
/// shipped name or a file. InputError where it cannot be read or used.
void changeTask(const std::string& scenario, EvidenceSource* source);

/// Leaves out the observations that lie beside the plane of a planar task, as a mapping of that
/// task does (MotionSpace::isBeside); how many these were.
std::size_t leaveOutBesideThePlane(Evidence* evidence);

}  // namespace smore
