// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <random>

#include "../scenario/temporary_directory.h"
#include "smore/experiment/belief_scores.h"
#include "smore/experiment/contact_place.h"
#include "smore/experiment/experiment.h"
#include "smore/experiment/first_touch.h"
#include "smore/experiment/score_report.h"
#include "smore/experiment/trial_recording.h"

namespace smore {
namespace {

TEST(ProperScores, areThoseOfTheirFormulas) {
  const std::vector<Forecast> forecasts = {{0.9, true}, {0.6, true}, {0.6, false}, {0.2, false}};
  EXPECT_NEAR(*logLoss(forecasts),
              -(std::log(0.9) + std::log(0.6) + std::log(0.4) + std::log(0.8)) / 4, 1e-12);
  // Each is told that 1 or 2 of the 3 others happened: (1 + 1/2) / 4 or (2 + 1/2) / 4.
  EXPECT_NEAR(*constantLogLoss(forecasts), -std::log(1.5 / 4), 1e-12);
  EXPECT_DOUBLE_EQ(*areaUnderCurve(forecasts), 3.5 / 4);
  EXPECT_FALSE(logLoss({}));
  EXPECT_FALSE(constantLogLoss({}));
  EXPECT_FALSE(areaUnderCurve({{0.5, true}}));
  EXPECT_TRUE(std::isinf(*logLoss({{0.0, true}})));
}

TEST(ProperScores, countEachForecastInItsBin) {
  const auto bins = reliability({{0.0, false}, {0.1, true}, {0.15, false}, {1.0, true}}, tenths());
  ASSERT_EQ(bins.size(), 10u);
  EXPECT_EQ(bins[0].count, 1);
  EXPECT_EQ(bins[1].count, 2) << "an edge belongs to the bin above";
  EXPECT_EQ(bins[9].count, 1) << "but for the last";
  EXPECT_DOUBLE_EQ(bins[1].stated, 0.125);
  EXPECT_DOUBLE_EQ(bins[1].happened, 0.5);
  EXPECT_DOUBLE_EQ(*calibrationError(bins), 2 * 0.375 / 4);
  EXPECT_DOUBLE_EQ(*largestError(bins, 2), 0.375);
  EXPECT_FALSE(largestError(bins, 3));
  EXPECT_FALSE(calibrationError(reliability({}, tenths())));
}

TEST(ProperScores, areBestForOneWhoStatesTheTruth) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Forecast> honest;
  std::vector<Forecast> bold;
  for (int i = 0; i < 6000; ++i) {
    const double p = 0.02 + 0.96 * uniform(random);
    const bool happened = uniform(random) < p;
    honest.push_back({p, happened});
    const double odds = std::pow(p / (1.0 - p), 2.0);
    bold.push_back({odds / (1.0 + odds), happened});
  }
  EXPECT_LT(*logLoss(honest), *logLoss(bold) - 0.02);
  EXPECT_LT(*logLoss(honest), *constantLogLoss(honest) - 0.1);
  EXPECT_LT(*calibrationError(reliability(honest, tenths())), 0.03);
  EXPECT_GT(*calibrationError(reliability(bold, tenths())), 0.05);
  EXPECT_EQ(*areaUnderCurve(honest), *areaUnderCurve(bold)) << "the order is the same";
}

TEST(EffectiveWorlds, areThoseThatWereDrawn) {
  std::mt19937_64 random(2);
  for (const int worlds : {8, 64}) {
    SeedScatter scatter;
    for (int event = 0; event < 4000; ++event) {
      std::binomial_distribution<int> touching(worlds, 0.1 + 0.8 * event / 4000.0);
      std::vector<double> shares(4);  // one for each seed
      for (double& share : shares) share = static_cast<double>(touching(random)) / worlds;
      scatter += scatterOf(shares);
    }
    EXPECT_NEAR(*effectiveWorlds(scatter), worlds, 0.05 * worlds);
  }
  EXPECT_FALSE(effectiveWorlds(scatterOf({0.5, 0.5})));
  EXPECT_FALSE(effectiveWorlds(scatterOf({1.0, 1.0, 1.0})));
  EXPECT_NEAR(*effectiveWorlds(scatterOf({0.0, 1.0})), 1.0, 1e-12);
}

TEST(FirstTouch, legsTakeEquallyLongAndMakeUpTheWay) {
  const MotionSpeed speed{0.1, 0.5};
  const Path path = {makePose({0, 0, 0}), makePose({1, 0, 0}), makePose({1, 0, 0}, {0, 0, 1}),
                     makePose({1, 0.3, 0}, {0, 0, 1})};  // 10 s, 2 s, 3 s
  const auto legs = legsOf(path, speed);
  ASSERT_EQ(legs.size(), static_cast<std::size_t>(kLegs));
  for (std::size_t i = 0; i < legs.size(); ++i) {
    double duration = 0.0;
    for (std::size_t k = 1; k < legs[i].size(); ++k) {
      duration += speed.timeBetween(legs[i][k - 1], legs[i][k]);
    }
    EXPECT_NEAR(duration, 15.0 / kLegs, 1e-9) << i;
    const Pose& end_before = i > 0 ? legs[i - 1].back() : path.front();
    EXPECT_EQ(legs[i].front().matrix(), end_before.matrix());
    EXPECT_EQ(legAt(legs, interpolate(legs[i].front(), legs[i][1], 0.5), speed),
              static_cast<int>(i));
  }
  EXPECT_TRUE(legs.back().back().isApprox(path.back(), 0.0));
  EXPECT_TRUE(legsOf({path[0], path[0]}, speed).empty());
  EXPECT_TRUE(legsOf({path[0]}, speed).empty());
}

TEST(FirstTouch, probabilitiesOfAllOutcomesSumToOne) {
  const std::vector<double> survival = {0.9, 0.9, 0.4, 0.1};
  double sum = std::exp(logFirstTouch(survival, std::nullopt));
  for (int leg = 0; leg < 4; ++leg) sum += std::exp(logFirstTouch(survival, leg));
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(logFirstTouch(survival, 2), std::log(0.5), 1e-12);
  EXPECT_NEAR(
      std::exp(logUniformTouch(0.8, std::nullopt)) + kLegs * std::exp(logUniformTouch(0.8, 3)), 1.0,
      1e-12);
}

TEST(ContactPlace, densityIsThatOfItsMixture) {
  LineOfAction line;
  line.direction = Vec3::UnitX();
  const std::vector<std::optional<Vec3>> places = {Vec3(0.1, 0, 0), Vec3(0.1, 0, 0), std::nullopt};
  const double kernel =
      std::exp(-0.5 * 4.0) / (0.01 * std::sqrt(2.0 * M_PI));  // two deviations off
  EXPECT_NEAR(logPlaceDensity(places, line, {0.12, 0.5, 0.7}, 0.01, 2.0, false),
              std::log((2 * kernel + 1 / 2.0 + 1 / 2.0) / 4), 1e-9);
  EXPECT_EQ(logPlaceDensity({}, line, Vec3::Zero(), 0.01, 2.0, false), std::log(1 / 2.0));
  // Over the line, within the range, it is normalised.
  double sum = 0.0;
  for (double x = -1.0; x < 1.0; x += 1e-3) {
    sum += 1e-3 * std::exp(logPlaceDensity(places, line, {x, 0, 0}, 0.01, 2.0, false));
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

TEST(ContactPlace, isTheMeanOfItsPointsWhereThatTouchesBothSolids) {
  TrialTruth truth;
  truth.object = {{BoxShape{{0.2, 0.2, 0.2}}, Pose::Identity()}};
  truth.environment = {{BoxShape{{0.2, 0.2, 0.2}}, makePose({0.2, 0.0, 0.0})}};
  truth.contacts[1] = {{{0.1, 0.04, 0.0}, {-3, 0, 0}, "object"},
                       {{0.1, 0.0, 0.0}, {-1, 0, 0}, "object"}};
  truth.contacts[2] = {{{0.1, 0.0, 0.0}, {-1, 0, 0}, "object"},
                       {{-0.1, 0.0, 0.0}, {-1, 0, 0}, "object"}};
  ContactObservation contact;
  contact.contact_id = 1;
  ASSERT_TRUE(truePlace(contact, truth));
  EXPECT_TRUE(truePlace(contact, truth)->isApprox(Vec3(0.1, 0.03, 0.0)));
  contact.contact_id = 2;
  EXPECT_FALSE(truePlace(contact, truth)) << "in the middle of the object";
  contact.contact_id = 3;
  EXPECT_FALSE(truePlace(contact, truth)) << "not recorded";
}

TEST(VoxelReliability, countsVoxelsThatTheSolidReaches) {
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 0.9F);  // centre at 0.05 on each axis
  grid.set({1, 0, 0}, 0.2F);
  grid.set({2, 0, 0}, 0.1F);
  const std::vector<Shape> half_space = {{BoxShape{{2, 2, 2}}, makePose({-0.9, 0, 0})}};  // to 0.1
  const auto forecasts = voxelForecasts(grid, half_space);
  ASSERT_EQ(forecasts.size(), 3u);
  EXPECT_TRUE(forecasts[0].happened);
  EXPECT_TRUE(forecasts[1].happened) << "half a voxel away";
  EXPECT_FALSE(forecasts[2].happened);
}

TEST(MapDifference, seesVoxelsOfEitherMap) {
  VoxelGrid a(0.1);
  VoxelGrid b(0.1);
  a.set({0, 0, 0}, 0.5F);
  a.set({1, 0, 0}, 0.25F);
  b.set({1, 0, 0}, 0.5F);
  b.set({2, 0, 0}, 0.125F);
  const MapDifference difference = differenceOf(a, b);
  EXPECT_EQ(difference.voxels, 3);
  EXPECT_DOUBLE_EQ(difference.largest, 0.5);
  EXPECT_DOUBLE_EQ(difference.sum, 0.875);
}

TEST(TrialScores, ofARecordedTrialAreCompleteAndRepeatable) {
  Scenario scene;
  scene.name = "small";
  scene.object = {{BoxShape{Vec3(0.06, 0.3, 0.06)}, Pose::Identity()}};
  scene.environment = {{CylinderShape{0.03, 0.3}, makePose(Vec3(-0.2, 0.1, 0.0))}};
  scene.goal = makePose(Vec3(-0.4, 0, 0));
  scene.workspace = {Vec3(-0.6, -0.4, -0.01), Vec3(0.2, 0.4, 0.01)};
  const TemporaryDirectory directory;
  ExperimentParameters parameters;
  parameters.record_directory = directory.path();
  const std::atomic<bool> interrupted{false};
  const auto result = runExperiment(scene, parameters, interrupted, [](const auto&) {}).at(0);
  const std::string file = evidenceFile(directory.path(), 1);
  const Evidence evidence = readEvidence(file);
  const TrialScores scores = scoreTrial(evidence, readTruth(file), kQuickEffort);
  ASSERT_TRUE(result.success);
  ASSERT_EQ(scores.risks.size(), result.motions.size());
  for (std::size_t i = 0; i < scores.risks.size(); ++i) {
    EXPECT_EQ(scores.risks[i].happened, result.motions[i].touched);
    EXPECT_NEAR(scores.risks[i].probability, result.motions[i].risk, 1e-12)
        << "the same belief says what the plan stated";
    EXPECT_EQ(scores.touches[i].leg.has_value(), result.motions[i].touched);
  }
  EXPECT_EQ(scores.places_after.size() + scores.contacts_of_many_places,
            static_cast<std::size_t>(result.collisions));
  EXPECT_EQ(scores.way_out.size(), result.motions.size() - 1) << "from the first contact on";
  const Json report = scoreReport({scores});
  ASSERT_EQ(report.size(), 2u);
  EXPECT_EQ(report[0]["group"], "small");
  EXPECT_EQ(report[1]["group"], "all in the plane");
  EXPECT_EQ(report, scoreReport({scoreTrial(evidence, readTruth(file), kQuickEffort)}));
}

}  // namespace
}  // namespace smore
