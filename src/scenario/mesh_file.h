// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

using TriangleSoup = std::vector<std::array<Vec3, 3>>;

/// The triangles of an STL or OBJ file as they stand there; polygons of an OBJ are split into fans.
/// InputError where the file cannot be read or is neither.
TriangleSoup readTriangles(const std::string& file);

}  // namespace smore
