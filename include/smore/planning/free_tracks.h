// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/free_cells.h"
#include "smore/planning/risk_space.h"
#include "smore/planning/risk_tree.h"

namespace smore {

/// Adds motions that were free, `tracks` [T_world_object], to a tree that is its root alone, so
/// that a search need not find them anew. Poses in one of the `cells` count as one: what was
/// entered twice is one node, at which a later track goes on. A track that meets neither begins
/// where a motion from the root is no longer than `longest` [m], in the metric of `motions`, and
/// touches in no world; what comes before, and a track without such a pose, is left out.
void plantTracks(const std::vector<Path>& tracks, const RiskSpace& space,
                 const FreeSpaceParameters& cells, const RiskMotions& motions, double longest,
                 RiskTree* tree);

}  // namespace smore
