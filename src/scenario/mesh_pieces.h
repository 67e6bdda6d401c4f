// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/common/geometry.h"
#include "smore/scenario/shape.h"

namespace smore {

/// A vertex of a piece of a closed mesh that is turned inside out, if there is one: its triangles
/// are clockwise from outside, and it is no hollow of another piece. Pieces are what hangs together
/// by vertices. `least` is the volume from which a piece counts [m^3].
std::optional<Vec3> pieceInsideOut(const MeshShape& mesh, double least);

}  // namespace smore
