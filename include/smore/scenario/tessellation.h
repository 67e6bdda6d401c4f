// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/scenario/shape.h"

namespace smore {

/// The surface of a solid as closed triangles, counter-clockwise from outside, in the parent frame.
/// Circles become polygons of 96 corners on the circle (within 0.06 % of the radius), spheres 48
/// bands of such; boxes and meshes are exact.
MeshShape tessellate(const Shape& shape);

}  // namespace smore
