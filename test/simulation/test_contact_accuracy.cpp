// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "../contact/distance_to_line.h"
#include "contact_trials.h"

namespace smore {
namespace {

constexpr int kTrials = 260;
constexpr int kSettlingSamples = 250;  // half a second

struct Accuracy {
  std::vector<double> line_errors;    ///< of the sensing's line, 30 to 50 ms after the contact [m]
  std::vector<double> static_errors;  ///< of the line of the wrench at rest [m]
  std::vector<double> forces;         ///< of the sensing's line [N]
  int jams = 0;
  int without_line = 0;
  int unbalanced = 0;  ///< sensor and contact points differ by more than 2 % and 0.05 N or N m
};

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1))];
}

bool agree(const Vec3& a, const Vec3& b) {
  return (a - b).norm() <= std::max(0.05, 0.02 * b.norm());
}

void addTrial(RandomContacts* trials, std::uint64_t seed, Accuracy* accuracy) {
  const Scenario scenario = trials->scene();
  const auto robot = makeSimulatedRobot(scenario, seed);
  const auto observation = touch(robot.get(), trials->target(scenario.start));
  if (!observation || robot->contacts().empty()) {
    ++accuracy->without_line;
    return;
  }
  if (!onOnePatch(scenario, robot->pose(), robot->contacts())) {
    ++accuracy->jams;
    return;
  }
  const LineOfAction line = transformLine(observation->T_world_object, *observation->line);
  accuracy->line_errors.push_back(distanceToLine(line, forceWeightedCenter(robot->contacts())));
  accuracy->forces.push_back(line.force);
  WrenchSample sample;
  for (int i = 0; i < kSettlingSamples; ++i) sample = robot->advance();
  const Wrench sum = sumOf(robot->contacts(), robot->pose());
  if (!agree(sample.wrench.force, sum.force) || !agree(sample.wrench.torque, sum.torque)) {
    ++accuracy->unbalanced;
  }
  const LineOfAction at_rest = transformLine(robot->pose(), *lineOfAction(sample.wrench, 1.0));
  accuracy->static_errors.push_back(
      distanceToLine(at_rest, forceWeightedCenter(robot->contacts())));
}

const Accuracy& accuracy() {
  static const Accuracy kAccuracy = [] {
    Accuracy result;
    RandomContacts trials(5);
    for (std::uint64_t seed = 0; seed < kTrials; ++seed) addTrial(&trials, seed, &result);
    return result;
  }();
  return kAccuracy;
}

TEST(ContactAccuracy, nearlyAllTrialsEndOnOnePatch) {
  EXPECT_GE(accuracy().line_errors.size(), 200u);
  EXPECT_LE(accuracy().jams, kTrials / 20);
  EXPECT_LE(accuracy().without_line, kTrials / 50);
}

TEST(ContactAccuracy, contactsArePressedWithModerateForce) {
  EXPECT_GT(percentile(accuracy().forces, 0.0), 2.5);
  EXPECT_LT(percentile(accuracy().forces, 1.0), 15.0);
}

TEST(ContactAccuracy, theSensedLinePassesTheContactPoints) {
  const auto& errors = accuracy().line_errors;
  RecordProperty("median_um", static_cast<int>(1e6 * percentile(errors, 0.5)));
  RecordProperty("percentile95_um", static_cast<int>(1e6 * percentile(errors, 0.95)));
  EXPECT_LT(percentile(errors, 0.5), 0.002);
  EXPECT_LT(percentile(errors, 0.95), 0.005);
}

TEST(ContactAccuracy, atRestTheLinePassesThemToAFractionOfAMillimetre) {
  EXPECT_LT(percentile(accuracy().static_errors, 0.5), 1e-5);
  EXPECT_LT(percentile(accuracy().static_errors, 0.95), 5e-4);
}

TEST(ContactAccuracy, atRestTheSensorBalancesTheContactForces) {
  EXPECT_EQ(accuracy().unbalanced, 0);
}

}  // namespace
}  // namespace smore
