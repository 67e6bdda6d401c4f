// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// common: what every other folder uses: poses, parameters, files, and what a robot is to the rest.

#include <cstdint>

namespace smore {

/// One number for a cell of a lattice, distinct for cells within 2^20 of the origin on each axis.
inline std::uint64_t cellKey(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::uint64_t kAxis = (std::uint64_t{1} << 21) - 1;
  return (static_cast<std::uint64_t>(x) & kAxis) | (static_cast<std::uint64_t>(y) & kAxis) << 21 |
         (static_cast<std::uint64_t>(z) & kAxis) << 42;
}

}  // namespace smore
