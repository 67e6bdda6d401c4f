// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/common/geometry.h"
#include "smore/scenario/shape.h"

namespace smore {

/// Reads an STL (ASCII or binary) or Wavefront OBJ file, each vertex multiplied by `scale`. Equal
/// vertices are merged and triangles are turned so that they are counter-clockwise from outside.
/// InputError with file and remedy: unreadable, another format, values that are not finite, a
/// surface that is not closed or not consistently turned, no volume.
MeshShape loadMesh(const std::string& file, const Vec3& scale);

/// Whether no vertex lies in front of the plane of a triangle (to a millionth of the mesh's size).
bool isConvex(const MeshShape& mesh);

/// Enclosed volume by the divergence theorem [m^3]; negative for triangles turned inside out.
double signedVolume(const MeshShape& mesh);

/// Signed distance of a point [m], in the mesh's frame: the distance to the nearest triangle,
/// negative where the winding number (sum of the triangles' solid angles over 4 pi) says inside.
double signedDistance(const MeshShape& mesh, const Vec3& point);

}  // namespace smore
