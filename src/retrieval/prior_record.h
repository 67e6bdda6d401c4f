// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/json_fields.h"
#include "smore/mapping/known_matter.h"

namespace smore {

/// A piece of prior knowledge, whole: its voxels as runs along x (docs/evidence.md).
Json priorRecord(MapSide side, const Prior& prior);

/// The same, read. InputError for missing or impossible values.
MapSide readPriorSide(const JsonFields& record);
Prior readPrior(const JsonFields& record);

}  // namespace smore
