// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "smore/retrieval/evidence.h"

namespace smore {

/// What to make of recorded evidence in another way than it was.
struct RebuildChanges {
  std::optional<MethodKind> method;
  std::optional<double> voxel_size;  ///< [m], positive
};

/// Makes the maps of the evidence and writes `world.ot`, `object.ot` and `summary.json` to
/// `directory`. Without changes the octrees are those of the trial, byte for byte. InputError for
/// evidence that does not fit into the maps; std::runtime_error where nothing can be written.
void rebuild(Evidence evidence, const RebuildChanges& changes, const std::string& directory);

}  // namespace smore
