// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/free_cells.h"
#include "smore/planning/risk_space.h"
#include "smore/planning/risk_tree.h"

namespace smore {

/// Adds motions that were free, `tracks` [T_world_object], to a tree as branches from its root, so
/// that a search need not find them anew. A track begins at its first pose in the root's cell of
/// `cells`, or to which a motion from the root is no longer than `longest` [m], in the metric of
/// `motions`, and touches in no world; what comes before, and a track without such a pose, is left
/// out.
void plantTracks(const std::vector<Path>& tracks, const RiskSpace& space,
                 const FreeSpaceParameters& cells, const RiskMotions& motions, double longest,
                 RiskTree* tree);

}  // namespace smore
