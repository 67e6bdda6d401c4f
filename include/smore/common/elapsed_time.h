// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace smore {

/// Of a clock that never jumps.
using SteadyClock = std::chrono::steady_clock;

/// Wall time since `begin` [s].
inline double secondsSince(SteadyClock::time_point begin) {
  return std::chrono::duration<double>(SteadyClock::now() - begin).count();
}

}  // namespace smore
