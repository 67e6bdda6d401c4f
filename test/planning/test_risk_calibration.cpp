// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "smore/planning/risk_calibration.h"

namespace smore {
namespace {

double withShift(double risk, double shift) {
  const double odds = risk / (1.0 - risk) * std::exp(shift);
  return odds / (1.0 + odds);
}

// In space odds above even ones count by their fourth root.
double counted(Motion motion, double risk) {
  if (motion == Motion::kPlanar || risk < 0.5) return risk;
  const double odds = std::pow(risk / (1.0 - risk), 0.25);
  return odds / (1.0 + odds);
}

TEST(RiskCalibration, expectsPlansToSayTheTruthInThePlane) {
  const RiskCalibration plane(Motion::kPlanar);
  for (const double risk : {0.01, 0.3, 0.5, 0.7, 0.99}) {
    EXPECT_NEAR(plane.corrected(risk), risk, 0.03);
  }
}

TEST(RiskCalibration, expectsPlansToSayTooLittleInSpaceAndTheHighestTooMuch) {
  const RiskCalibration space(Motion::kSpatial);
  for (const double risk : {0.01, 0.3, 0.5, 0.7}) {
    EXPECT_GT(space.corrected(risk), risk);
    EXPECT_LT(space.corrected(risk), withShift(risk, 2.0));
  }
  EXPECT_LT(space.corrected(0.99), 0.95);
}

TEST(RiskCalibration, keepsTheOrderOfPlansAndWhatIsCertain) {
  RiskCalibration calibration(Motion::kSpatial);
  calibration.learn(0.2, true);
  double before = calibration.corrected(0.0);
  EXPECT_EQ(before, 0.0);
  for (double risk = 0.01; risk < 1.0; risk += 0.01) {
    EXPECT_GT(calibration.corrected(risk), before);
    before = calibration.corrected(risk);
  }
  EXPECT_EQ(calibration.corrected(1.0), 1.0);
}

TEST(RiskCalibration, learnsNothingFromWhatWasCertain) {
  RiskCalibration calibration(Motion::kSpatial);
  const double before = calibration.corrected(0.4);
  calibration.learn(0.0, true);
  calibration.learn(1.0, false);
  EXPECT_EQ(calibration.corrected(0.4), before);
}

// Forecasts whose odds are off by one factor, in either direction.
TEST(RiskCalibration, findsHowFarStatedRisksAreOff) {
  for (const Motion motion : {Motion::kPlanar, Motion::kSpatial}) {
    for (const double shift : {-1.5, 0.0, 2.0}) {
      RiskCalibration calibration(motion);
      std::mt19937 random(17);
      std::uniform_real_distribution<double> uniform(0.0, 1.0);
      for (int i = 0; i < 2000; ++i) {
        const double risk = 0.02 + 0.96 * uniform(random);
        calibration.learn(risk, uniform(random) < withShift(counted(motion, risk), shift));
      }
      for (const double risk : {0.1, 0.5, 0.9}) {
        const double contact = withShift(counted(motion, risk), shift);
        EXPECT_NEAR(calibration.corrected(risk), contact, 0.05) << shift;
      }
    }
  }
}

// The posterior by a fine integral over the shift.
TEST(RiskCalibration, followsBayesRule) {
  const std::pair<Motion, double> means[] = {{Motion::kPlanar, 0.0}, {Motion::kSpatial, 1.5}};
  for (const auto& [motion, mean] : means) {
    RiskCalibration calibration(motion);
    calibration.learn(0.3, true);
    calibration.learn(0.6, false);
    double contact = 0.0;
    double sum = 0.0;
    for (double shift = -6.0; shift < 8.0; shift += 0.001) {
      const double weight = std::exp(-0.5 * std::pow((shift - mean) / 0.7, 2)) *
                            withShift(0.3, shift) * (1.0 - withShift(counted(motion, 0.6), shift));
      contact += weight * withShift(counted(motion, 0.8), shift);
      sum += weight;
    }
    EXPECT_NEAR(calibration.corrected(0.8), contact / sum, 1e-4);
  }
}

// Nothing overflows however long a run goes on one way.
TEST(RiskCalibration, staysAProbabilityInLongRuns) {
  for (const bool touched : {true, false}) {
    RiskCalibration calibration(Motion::kSpatial);
    for (int i = 0; i < 100000; ++i) calibration.learn(0.5, touched);
    EXPECT_GT(calibration.corrected(0.5), 0.0);
    EXPECT_LT(calibration.corrected(0.5), 1.0);
    EXPECT_EQ(calibration.corrected(0.5) > 0.9, touched);
  }
}

}  // namespace
}  // namespace smore
