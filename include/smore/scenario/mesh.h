// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// scenario: scenes and tasks as they are read from files.

#include <string>

#include "smore/common/geometry.h"
#include "smore/scenario/shape.h"

namespace smore {

/// No scene is larger, or farther from its own origin [m].
constexpr double kLargestScene = 100.0;
/// Nor is anything that a gripper holds [m]: a centimetre in a file of millimetres is.
constexpr double kLargestHeld = 10.0;

/// Reads an STL, OBJ, PLY or DAE file, each vertex multiplied by `scale`. Equal vertices are joined
/// and triangles are turned so that they are counter-clockwise from outside. InputError with file
/// and remedy: unreadable, another format, values that are not finite, more than `largest` [m]
/// large or from its own origin, a surface that is not closed or not consistently turned (each of
/// its pieces as well, but for hollows), no volume.
MeshShape loadMesh(const std::string& file, const Vec3& scale, double largest = kLargestScene);

/// What a convex mesh may lie below its hull, in diagonals of its bounding box: what files round
/// (a micrometre where they give six decimals of a metre) for solids from a centimetre.
constexpr double kConvexTolerance = 1e-4;

/// Whether the mesh is its convex hull, to the tolerance.
bool isConvex(const MeshShape& mesh);

/// Whether bodies may collide with the hull of the mesh instead: it is convex and has 2000
/// triangles at most. The time that a hull takes grows with its corners.
bool servesAsHull(const MeshShape& mesh);

/// Enclosed volume by the divergence theorem [m^3]; negative for triangles turned inside out.
double signedVolume(const MeshShape& mesh);

}  // namespace smore
