// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/scenario/shape.h"

namespace smore {

/// Cuts a closed mesh into convex parts by hierarchical approximate convex decomposition
/// (K. Mamou and F. Ghorbel, A simple and efficient approach for 3D mesh approximate convex
/// decomposition, ICIP 2009; the library HACD). Large meshes are made coarser first. Sets the
/// mesh's `parts` and `parts_error`. Throws an InputError where the mesh is so thin that nothing of
/// it is left when it is made coarser.
void decompose(MeshShape* mesh);

}  // namespace smore
