// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/scenario/scenario.h"

namespace smore {

/// The scenario as read, as JSON: all keys of a scenario file (docs/scenarios.md), given or not.
/// Each shape has its `triangles` besides: three corners [x, y, z] each, counter-clockwise from
/// outside, the object's in the object frame, the environment's in the world [m].
std::string toJson(const Scenario& scenario);

}  // namespace smore
