// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

namespace smore {

/// A probability that was stated for an event, and whether the event came about.
struct Forecast {
  double probability = 0.0;  ///< in [0, 1]
  bool happened = false;
};

/// Mean of -log of the probability of what came about [nat], docs/scoring.md (E1); smaller is
/// better. Infinite where something came about that was stated to be impossible; nothing without
/// forecasts.
std::optional<double> logLoss(const std::vector<Forecast>& forecasts);

/// The same, for one who always states the base rate, docs/scoring.md (E2). Each event's rate is
/// that of all others, with Jeffreys' prior: (k + 1/2) / n where k of the other n - 1 happened, so
/// that no event tells its own outcome.
std::optional<double> constantLogLoss(const std::vector<Forecast>& forecasts);

/// Probability that of two events, one of which happened, that one had the larger probability;
/// equal ones count half (the area under the ROC curve). Nothing where all or none happened.
std::optional<double> areaUnderCurve(const std::vector<Forecast>& forecasts);

/// Forecasts whose probability lies in [low, high), the last bin's end included.
struct ReliabilityBin {
  double low = 0.0;
  double high = 1.0;
  int count = 0;
  double stated = 0.0;    ///< mean probability
  double happened = 0.0;  ///< share that happened
};

/// `edges`: ascending, from 0 to 1.
std::vector<ReliabilityBin> reliability(const std::vector<Forecast>& forecasts,
                                        const std::vector<double>& edges);

/// Ten bins of equal width.
std::vector<double> tenths();

/// Mean distance of stated and happened over the bins, weighed by their counts (expected
/// calibration error); nothing without forecasts.
std::optional<double> calibrationError(const std::vector<ReliabilityBin>& bins);

/// Largest distance of stated and happened among the bins with at least `least` forecasts.
std::optional<double> largestError(const std::vector<ReliabilityBin>& bins, int least);

}  // namespace smore
