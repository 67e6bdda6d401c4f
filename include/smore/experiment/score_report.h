// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/json.h"
#include "smore/experiment/belief_scores.h"

namespace smore {

/// Scores of trials put together: for each scene, and for all in the plane and all in space
/// (docs/scoring.md). A score that nothing can be said of is null.
Json scoreReport(const std::vector<TrialScores>& trials);

}  // namespace smore
