// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_calibration.h"

#include <cmath>
#include <numeric>

namespace smore {
namespace {

// Prior of the shift of the log odds, normal. In a plane plans say the truth on average; in space
// the mean was chosen on tuning seeds of four kinds of scenes, and the deviation on these and six
// planar scenes (docs/research_notes.md).
constexpr double kMeanInSpace = 1.5;
constexpr double kDeviation = 0.7;

// In space so much counts of the log odds that are above even ones, chosen with the mean: how many
// more than half of the worlds touch tells little there.
constexpr double kShareAboveEven = 0.25;

// The shifts that are told apart: four deviations and more about either mean.
constexpr double kLeastShift = -3.0;
constexpr double kStep = 0.1;

bool isCertain(double risk) { return risk <= 0.0 || risk >= 1.0; }

double logistic(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

template <typename Weights>
void normalise(Weights* weights) {
  const double sum = std::accumulate(weights->begin(), weights->end(), 0.0);
  for (double& weight : *weights) weight /= sum;
}

}  // namespace

RiskCalibration::RiskCalibration(Motion motion) : motion_(motion) {
  const double mean = motion == Motion::kSpatial ? kMeanInSpace : 0.0;
  for (int i = 0; i < kShifts; ++i) {
    weights_[i] = std::exp(-0.5 * std::pow((shift(i) - mean) / kDeviation, 2));
  }
  normalise(&weights_);
}

double RiskCalibration::shift(int index) { return kLeastShift + kStep * index; }

double RiskCalibration::logOdds(double risk) const {
  const double stated = std::log(risk) - std::log1p(-risk);
  return motion_ == Motion::kSpatial && stated > 0.0 ? kShareAboveEven * stated : stated;
}

double RiskCalibration::corrected(double risk) const {
  if (isCertain(risk)) return risk;
  const double log_odds = logOdds(risk);
  double sum = 0.0;
  for (int i = 0; i < kShifts; ++i) sum += weights_[i] * logistic(log_odds + shift(i));
  return sum;
}

void RiskCalibration::learn(double risk, bool touched) {
  if (isCertain(risk)) return;
  const double log_odds = logOdds(risk);
  for (int i = 0; i < kShifts; ++i) {
    const double contact = logistic(log_odds + shift(i));
    weights_[i] *= touched ? contact : 1.0 - contact;
  }
  normalise(&weights_);
}

}  // namespace smore
