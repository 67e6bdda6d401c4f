// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "smore/experiment/experiment.h"

namespace smore {
namespace {

TrialResult trialWith(std::uint64_t seed, bool success, int collisions) {
  TrialResult trial;
  trial.seed = seed;
  trial.success = success;
  trial.collisions = collisions;
  trial.world_map.distances = {0.01, 0.02};
  return trial;
}

nlohmann::json jsonOf(const std::vector<TrialResult>& trials, Task task = Task::kRetrieve) {
  Scenario scenario;
  scenario.name = "name";
  scenario.task = task;
  return nlohmann::json::parse(toJson(scenario, ExperimentParameters{}, trials));
}

TEST(ToJson, holdsEachTrialAndTheStatistics) {
  const auto json = jsonOf({trialWith(1, true, 2), trialWith(2, false, 9), trialWith(3, true, 4)});
  EXPECT_EQ(json["scenario"], "name");
  EXPECT_EQ(json["method"], "smore");
  EXPECT_EQ(json["trials"].size(), 3u);
  EXPECT_EQ(json["trials"][1]["collisions"], 9);
  EXPECT_TRUE(json["trials"][0]["object_map"]["precision"].is_null());
  EXPECT_FALSE(json["trials"][0]["world_map"].contains("distances"));
  const auto& collisions = json["summary"]["collisions"];
  EXPECT_NEAR(json["summary"]["success_rate"], 2.0 / 3.0, 1e-12);
  EXPECT_EQ(collisions["mean"], 5.0);
  EXPECT_EQ(collisions["median"], 4.0);
  EXPECT_EQ(collisions["min"], 2);
  EXPECT_EQ(collisions["max"], 9);
  EXPECT_NEAR(collisions["stddev"], std::sqrt(13.0), 1e-12);
}

TEST(ToJson, pairsTheRiskOfEachMotionWithItsEnd) {
  TrialResult trial = trialWith(1, true, 1);
  trial.motions = {{0.75, true}, {0.25, false}};
  const auto motions = jsonOf({trial})["trials"][0]["motions"];
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0]["risk"], 0.75);
  EXPECT_EQ(motions[0]["touched"], true);
  EXPECT_EQ(motions[1]["touched"], false);
}

TEST(ToJson, recordsTheParametersOfTheMethod) {
  ExperimentParameters parameters;
  parameters.method_parameters.belief.feature.radius = 0.0125;
  const auto smore = nlohmann::json::parse(toJson(Scenario{}, parameters, {}));
  EXPECT_EQ(smore["parameters"]["belief"]["radius"], 0.0125);
  EXPECT_EQ(smore["parameters"]["planner"]["paths"], RiskPlannerParameters{}.paths);
  parameters.method = MethodKind::kCspace;
  EXPECT_FALSE(nlohmann::json::parse(toJson(Scenario{}, parameters, {})).contains("parameters"));
}

TEST(ToJson, givesNullWhereThereIsNothingToDivideBy) {
  const auto none = jsonOf({});
  EXPECT_TRUE(none["summary"]["success_rate"].is_null());
  EXPECT_TRUE(none["summary"]["collisions"]["mean"].is_null());
  EXPECT_TRUE(none["summary"]["collisions"]["max"].is_null());
  EXPECT_TRUE(jsonOf({trialWith(1, true, 2)})["summary"]["collisions"]["stddev"].is_null());
}

TEST(ToJson, addsDistancesToReconstructions) {
  const auto json = jsonOf({trialWith(1, true, 2)}, Task::kReconstruct);
  EXPECT_EQ(json["trials"][0]["world_map"]["distances"].size(), 2u);
}

}  // namespace
}  // namespace smore
