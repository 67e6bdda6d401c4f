// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace smore {

/// Processor cores, at least 1.
inline std::size_t coreCount() { return std::max(1U, std::thread::hardware_concurrency()); }

/// Calls `work(i)` for each i below `count`, on all processor cores at once; returns when all calls
/// have. The calls must not depend on one another, nor throw.
template <typename Work>
void parallelFor(std::size_t count, const Work& work) {
  const std::size_t threads = std::min(coreCount(), count);
  const auto share = [&](std::size_t first) {
    for (std::size_t i = first; i < count; i += threads) work(i);
  };
  std::vector<std::thread> others;
  for (std::size_t first = 1; first < threads; ++first) others.emplace_back(share, first);
  share(0);
  for (std::thread& other : others) other.join();
}

}  // namespace smore
