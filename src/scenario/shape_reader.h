// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/parameters.h"
#include "smore/scenario/shape.h"

namespace smore {

/// Reads `shapes:` under `key` of a scenario; mesh files are relative to `directory`. Problems go
/// to the reader's list. Where the body `moves`, concave meshes get convex parts.
std::vector<Shape> readShapes(ParameterReader* reader, const std::string& key,
                              const std::string& directory, bool moves);

/// Reads `position` and, where given, `rpy` of a pose.
Pose readPose(ParameterReader* reader);

}  // namespace smore
