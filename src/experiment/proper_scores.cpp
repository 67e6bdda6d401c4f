// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/proper_scores.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

int countHappened(const std::vector<Forecast>& forecasts) {
  return static_cast<int>(
      std::count_if(forecasts.begin(), forecasts.end(),
                    [](const Forecast& forecast) { return forecast.happened; }));
}

double lossOf(double probability, bool happened) {
  return -std::log(happened ? probability : 1.0 - probability);
}

}  // namespace

std::optional<double> logLoss(const std::vector<Forecast>& forecasts) {
  if (forecasts.empty()) return std::nullopt;
  double sum = 0.0;
  for (const Forecast& forecast : forecasts) {
    sum += lossOf(forecast.probability, forecast.happened);
  }
  return sum / static_cast<double>(forecasts.size());
}

std::optional<double> constantLogLoss(const std::vector<Forecast>& forecasts) {
  const int happened = countHappened(forecasts);
  const auto count = static_cast<double>(forecasts.size());
  std::vector<Forecast> constant;
  constant.reserve(forecasts.size());
  for (const Forecast& forecast : forecasts) {
    const int others = happened - (forecast.happened ? 1 : 0);
    constant.push_back({(others + 0.5) / count, forecast.happened});
  }
  return logLoss(constant);
}

std::optional<double> areaUnderCurve(const std::vector<Forecast>& forecasts) {
  const double happened = countHappened(forecasts);
  const double rest = static_cast<double>(forecasts.size()) - happened;
  if (happened == 0.0 || rest == 0.0) return std::nullopt;
  double wins = 0.0;
  for (const Forecast& one : forecasts) {
    if (!one.happened) continue;
    for (const Forecast& other : forecasts) {
      if (other.happened) continue;
      if (one.probability > other.probability) wins += 1.0;
      if (one.probability == other.probability) wins += 0.5;
    }
  }
  return wins / (happened * rest);
}

std::vector<ReliabilityBin> reliability(const std::vector<Forecast>& forecasts,
                                        const std::vector<double>& edges) {
  std::vector<ReliabilityBin> bins;
  for (std::size_t i = 1; i < edges.size(); ++i) bins.push_back({edges[i - 1], edges[i]});
  for (const Forecast& forecast : forecasts) {
    const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, forecast.probability);
    ReliabilityBin& bin = bins[above - edges.begin() - 1];
    ++bin.count;
    bin.stated += forecast.probability;
    bin.happened += forecast.happened ? 1.0 : 0.0;
  }
  for (ReliabilityBin& bin : bins) {
    if (bin.count == 0) continue;
    bin.stated /= bin.count;
    bin.happened /= bin.count;
  }
  return bins;
}

std::vector<double> tenths() {
  std::vector<double> edges;
  for (int i = 0; i <= 10; ++i) edges.push_back(i / 10.0);
  return edges;
}

std::optional<double> calibrationError(const std::vector<ReliabilityBin>& bins) {
  double sum = 0.0;
  int count = 0;
  for (const ReliabilityBin& bin : bins) {
    sum += bin.count * std::abs(bin.stated - bin.happened);
    count += bin.count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

std::optional<double> largestError(const std::vector<ReliabilityBin>& bins, int least) {
  std::optional<double> largest;
  for (const ReliabilityBin& bin : bins) {
    if (bin.count < std::max(least, 1)) continue;
    largest = std::max(largest.value_or(0.0), std::abs(bin.stated - bin.happened));
  }
  return largest;
}

}  // namespace smore
