// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/json_fields.h"
#include "smore/scenario/shape.h"

namespace smore {

/// One solid with all of its geometry, a mesh with its vertices and triangles.
Json toJson(const Shape& shape);

/// InputError for missing or impossible values.
Shape readShape(const JsonFields& fields);

}  // namespace smore
