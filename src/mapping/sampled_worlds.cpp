// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/sampled_worlds.h"

#include <algorithm>

namespace smore {

void SampledWorlds::prepareTouching() const {
  for (const WorldsAtUnit& part : parts_) part.prepareTouching();
}

HypothesisMask SampledWorlds::touching(const Eigen::Isometry3f& T_map_object, int enough) const {
  HypothesisMask result = 0;
  for (const WorldsAtUnit& part : parts_) {
    result |= part.touching(T_map_object, enough);
    if (__builtin_popcountll(result) > enough) break;
  }
  return result;
}

double SampledWorlds::unknownShareAt(const Eigen::Isometry3f& T_map_object) const {
  if (parts_.empty()) return 1.0;
  double worlds = 0.0;
  for (const WorldsAtUnit& part : parts_) worlds += part.unknownWorldsAt(T_map_object);
  return worlds / kHypotheses;
}

double SampledWorlds::knownReach() const {
  float farthest = 0.0F;
  for (const WorldsAtUnit& part : parts_) {
    for (const KnownBalls& known : part.knownObject()) {
      for (const MaskedPoint& ball : known.balls) farthest = std::max(farthest, ball.point.norm());
    }
  }
  return farthest;
}

}  // namespace smore
