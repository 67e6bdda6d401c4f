// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/probability_laws.h"

#include <cmath>

namespace smore {
namespace {

// 1 - Pi and 1 - Pi / (1 - p q) are small when the priors are: summing logarithms and expm1 keep
// their digits.
double probabilityOfAny(double log_none) { return -std::expm1(log_none); }

double updated(double p, double q, double any, double any_other) {
  return p * (q + any_other * (1.0 - q)) / any;
}

}  // namespace

std::vector<VoxelPair> contactLaw(const std::vector<VoxelPair>& pairs) {
  double log_none = 0.0;
  for (const VoxelPair& pair : pairs) {
    if (pair.p * pair.q >= 1.0) return pairs;
    log_none += std::log1p(-pair.p * pair.q);
  }
  const double any = probabilityOfAny(log_none);
  if (any <= 0.0) return pairs;

  std::vector<VoxelPair> posterior;
  posterior.reserve(pairs.size());
  for (const VoxelPair& pair : pairs) {
    const double any_other = probabilityOfAny(log_none - std::log1p(-pair.p * pair.q));
    posterior.push_back(
        {updated(pair.p, pair.q, any, any_other), updated(pair.q, pair.p, any, any_other)});
  }
  return posterior;
}

VoxelPair freeSpaceLaw(const VoxelPair& pair) {
  const double apart = 1.0 - pair.p * pair.q;
  if (apart <= 0.0) return pair;
  return {pair.p * (1.0 - pair.q) / apart, pair.q * (1.0 - pair.p) / apart};
}

}  // namespace smore
