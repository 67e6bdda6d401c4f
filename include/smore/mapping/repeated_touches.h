// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// Those of the poses that have another one within `tolerance` [m], a turn counting as far as it
/// moves what lies `reach` [m] from the origin; in their order. For poses of contacts: where the
/// object touched and a motion that was to pass touched again, what explains the contacts is wrong
/// there, and that it touches is all that is certain.
std::vector<Pose> repeatedTouches(const std::vector<Pose>& poses, double tolerance, double reach);

}  // namespace smore
