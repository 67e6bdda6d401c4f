// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/believed_prior.h"

#include <utility>

namespace smore {

HypothesisMask BelievedPrior::worldsOf(PriorMask pieces) const {
  HypothesisMask result = 0;
  for (std::size_t piece = 0; piece < worlds.size(); ++piece) {
    if (((pieces >> piece) & 1U) != 0) result |= worlds[piece];
  }
  return result;
}

HypothesisMask BelievedPrior::knowing(MapSide side, const Eigen::Vector3f& place) const {
  HypothesisMask result = 0;
  for (int piece = 0; piece < evidence.count(); ++piece) {
    const KnownMatter& known = evidence.known(piece);
    if (known.side() == side && known.matterAt(place).has_value()) result |= worlds[piece];
  }
  return result;
}

HypothesisMask BelievedPrior::knowingFree(MapSide side, const Eigen::Vector3f& place) const {
  HypothesisMask result = 0;
  for (int piece = 0; piece < evidence.count(); ++piece) {
    const KnownMatter& known = evidence.known(piece);
    if (known.side() == side && known.matterAt(place) == false) result |= worlds[piece];
  }
  return result;
}

std::vector<KnownBalls> BelievedPrior::balls(MapSide side) const {
  std::vector<KnownBalls> result;
  for (const KnownBalls& known : evidence.balls(side)) {
    KnownBalls believed{{}, known.radius, known.tolerance};
    for (const MaskedPoint& ball : known.balls) {
      const HypothesisMask mask = worldsOf(ball.mask);
      if (mask != 0) believed.balls.push_back({ball.point, mask});
    }
    if (!believed.balls.empty()) result.push_back(std::move(believed));
  }
  return result;
}

}  // namespace smore
