// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/effective_worlds.h"

#include <numeric>

namespace smore {

SeedScatter& SeedScatter::operator+=(const SeedScatter& other) {
  binomial += other.binomial;
  variance += other.variance;
  return *this;
}

SeedScatter scatterOf(const std::vector<double>& shares) {
  const auto seeds = static_cast<double>(shares.size());
  const double mean = std::accumulate(shares.begin(), shares.end(), 0.0) / seeds;
  double squares = 0.0;
  for (const double share : shares) squares += (share - mean) * (share - mean);
  const double variance = squares / (seeds - 1.0);
  return {mean * (1.0 - mean) + variance / seeds, variance};
}

std::optional<double> effectiveWorlds(const SeedScatter& scatter) {
  if (!(scatter.variance > 0.0)) return std::nullopt;
  return scatter.binomial / scatter.variance;
}

}  // namespace smore
