// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

namespace smore {

/// What the shares of worlds say about the worlds' number, drawn anew with several seeds: sums over
/// events, so that those of several trials can be added.
struct SeedScatter {
  double binomial = 0.0;  ///< sum of p (1 - p): the variance between seeds if there were one world
  double variance = 0.0;  ///< sum of the variances between seeds

  SeedScatter& operator+=(const SeedScatter& other);
};

/// `shares`: of one event, one for each seed; at least two.
///
/// Of N independent worlds a share p varies by p (1 - p) / N. With the sample's variance v of S
/// seeds, mean (1 - mean) + v / S estimates p (1 - p) without bias.
SeedScatter scatterOf(const std::vector<double>& shares);

/// The number of independent worlds that would scatter as much, docs/scoring.md (E5); nothing where
/// nothing scatters.
std::optional<double> effectiveWorlds(const SeedScatter& scatter);

}  // namespace smore
