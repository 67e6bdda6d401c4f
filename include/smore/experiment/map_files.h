// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/mapping/twin_map.h"

namespace smore {

constexpr const char* kWorldMapFile = "world.ot";
constexpr const char* kObjectMapFile = "object.ot";

/// Writes both maps by these names (OctoMap's own format) to `directory`, which is made where it
/// is missing. std::runtime_error where they cannot be written.
void saveMaps(const TwinMap& maps, const std::string& directory);

}  // namespace smore
