// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// Points of a PCD file (ascii or binary, not compressed) or of the vertices of a PLY file (ascii
/// or little-endian), as they stand there [m]; those that are not finite are left out, as a
/// camera's files have them where it saw nothing. InputError with file and remedy: unreadable,
/// another format, no field x, y or z, shorter than its header says, no point at all.
std::vector<Vec3> loadPointCloud(const std::string& file);

/// Whether a PLY file has faces, so that it is a mesh. False for any other file.
bool hasFaces(const std::string& file);

}  // namespace smore
