// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/contact/line_of_action.h"

namespace smore {

/// Distance of a point to the line [m], both in one frame.
inline double distanceToLine(const LineOfAction& line, const Vec3& point) {
  return (point - line.point).cross(line.direction).norm();
}

}  // namespace smore
