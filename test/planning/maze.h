// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "voxel_oracle.h"

namespace smore::oracle {

/// A room of 1.2 m by 0.8 m with two walls that leave gaps at opposite ends, in the plane z = 0.
inline std::vector<Block> slalom() {
  return {
      {{-0.6, -0.5, -0.045}, {0.6, -0.4, 0.045}},    {{-0.6, 0.4, -0.045}, {0.6, 0.5, 0.045}},
      {{-0.7, -0.5, -0.045}, {-0.6, 0.5, 0.045}},    {{0.6, -0.5, -0.045}, {0.7, 0.5, 0.045}},
      {{-0.24, -0.4, -0.045}, {-0.18, 0.15, 0.045}}, {{0.18, -0.15, -0.045}, {0.24, 0.4, 0.045}}};
}

/// A bar that passes the slalom's gaps at some angles only.
inline std::vector<Block> bar() { return {{{-0.15, -0.03, -0.03}, {0.15, 0.03, 0.03}}}; }

/// A wall across the box, with a slot that a bar passes lengthwise only.
inline std::vector<Block> slottedWall() {
  return {{{-0.06, -0.6, -0.6}, {0.06, -0.09, 0.6}},
          {{-0.06, 0.09, -0.6}, {0.06, 0.6, 0.6}},
          {{-0.06, -0.09, -0.6}, {0.06, 0.09, -0.09}},
          {{-0.06, -0.09, 0.09}, {0.06, 0.09, 0.6}}};
}

}  // namespace smore::oracle
