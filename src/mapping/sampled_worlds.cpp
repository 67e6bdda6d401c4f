// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/sampled_worlds.h"

namespace smore {

HypothesisMask SampledWorlds::touching(const Eigen::Isometry3f& T_map_object, int enough) const {
  HypothesisMask result = 0;
  for (const WorldsAtUnit& part : parts_) {
    result |= part.touching(T_map_object, enough);
    if (__builtin_popcountll(result) > enough) break;
  }
  return result;
}

}  // namespace smore
