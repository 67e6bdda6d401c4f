// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// Vertices and the triangles that they make, as a file has them.
struct MeshFile {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
};

/// Reads an STL, OBJ, PLY or DAE file with assimp: all its solids in the coordinates of the file
/// (of a DAE with its nodes' transforms and its unit, in metres, but not turned for its up axis),
/// polygons cut into triangles, equal vertices joined, triangles of which two corners coincide left
/// out. Coordinates are those of 32-bit floats. InputError where the file cannot be read as such.
MeshFile readMeshFile(const std::string& file);

}  // namespace smore
