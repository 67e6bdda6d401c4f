// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_calibration.h"

#include <cmath>
#include <numeric>

namespace smore {
namespace {

// Prior of the shift of the log odds, normal. In a plane plans say the truth on average; in space
// the mean was chosen on tuning seeds of four scenes, and the deviation on these and six planar
// ones (docs/research_notes.md).
constexpr double kMeanInSpace = 1.0;
constexpr double kDeviation = 0.7;

// The shifts that are told apart: as far as eight deviations.
constexpr double kLeastShift = -3.0;
constexpr double kStep = 0.1;

bool isCertain(double risk) { return risk <= 0.0 || risk >= 1.0; }

double shifted(double risk, double shift) {
  return 1.0 / (1.0 + (1.0 - risk) / risk * std::exp(-shift));
}

template <typename Weights>
void normalise(Weights* weights) {
  const double sum = std::accumulate(weights->begin(), weights->end(), 0.0);
  for (double& weight : *weights) weight /= sum;
}

}  // namespace

RiskCalibration::RiskCalibration(Motion motion) {
  const double mean = motion == Motion::kSpatial ? kMeanInSpace : 0.0;
  for (int i = 0; i < kShifts; ++i) {
    weights_[i] = std::exp(-0.5 * std::pow((shift(i) - mean) / kDeviation, 2));
  }
  normalise(&weights_);
}

double RiskCalibration::shift(int index) { return kLeastShift + kStep * index; }

double RiskCalibration::corrected(double risk) const {
  if (isCertain(risk)) return risk;
  double sum = 0.0;
  for (int i = 0; i < kShifts; ++i) sum += weights_[i] * shifted(risk, shift(i));
  return sum;
}

void RiskCalibration::learn(double risk, bool touched) {
  if (isCertain(risk)) return;
  for (int i = 0; i < kShifts; ++i) {
    const double contact = shifted(risk, shift(i));
    weights_[i] *= touched ? contact : 1.0 - contact;
  }
  normalise(&weights_);
}

}  // namespace smore
