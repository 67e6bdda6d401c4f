// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>

#include "bar_behind_peg.h"
#include "smore/experiment/experiment.h"

namespace smore {
namespace {

const std::atomic<bool> kNotInterrupted{false};

ExperimentParameters parametersFor(MethodKind method) {
  ExperimentParameters parameters;
  parameters.method = method;
  parameters.trials = 2;
  parameters.max_collisions = 300;
  return parameters;
}

class EachMethod : public ::testing::TestWithParam<MethodKind> {};

TEST_P(EachMethod, bringsTheObjectToTheGoal) {
  Scenario scenario = barBehindPeg();
  if (GetParam() == MethodKind::kChs) scenario.prior.object = {PriorSource{}};
  const auto trials =
      runExperiment(scenario, parametersFor(GetParam()), kNotInterrupted, [](const auto&) {});
  ASSERT_EQ(trials.size(), 2u);
  for (const TrialResult& trial : trials) {
    EXPECT_TRUE(trial.success) << trial.reason;
    EXPECT_GT(trial.collisions, 0) << "the straight way is blocked";
    EXPECT_GE(trial.plans, trial.collisions + 1);
    EXPECT_GT(trial.path_length, 0.4 - 0.02);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, EachMethod,
                         ::testing::Values(MethodKind::kPaper, MethodKind::kCspace,
                                           MethodKind::kSmore, MethodKind::kBlocked,
                                           MethodKind::kChs),
                         [](const auto& instance) { return methodName(instance.param); });

TEST(RunExperiment, givesTheSameResultsWithTwoJobs) {
  ExperimentParameters parameters = parametersFor(MethodKind::kPaper);
  parameters.trials = 4;
  const auto one = runExperiment(barBehindPeg(), parameters, kNotInterrupted, [](const auto&) {});
  parameters.jobs = 2;
  const auto two = runExperiment(barBehindPeg(), parameters, kNotInterrupted, [](const auto&) {});
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].seed, i + 1);
    EXPECT_EQ(one[i].seed, two[i].seed);
    EXPECT_EQ(one[i].collisions, two[i].collisions);
    EXPECT_EQ(one[i].plans, two[i].plans);
    EXPECT_EQ(one[i].path_length, two[i].path_length);
    EXPECT_EQ(one[i].simulated_s, two[i].simulated_s);
    EXPECT_EQ(one[i].world_map.occupied, two[i].world_map.occupied);
  }
}

TEST(RunExperiment, stopsAtTheCollisionLimit) {
  ExperimentParameters parameters = parametersFor(MethodKind::kPaper);
  parameters.trials = 1;
  parameters.max_collisions = 1;
  const auto trials =
      runExperiment(barBehindPeg(), parameters, kNotInterrupted, [](const auto&) {});
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_FALSE(trials[0].success);
  EXPECT_EQ(trials[0].collisions, 1);
}

TEST(RunExperiment, leavesInterruptedTrialsOut) {
  std::atomic<bool> interrupted{false};
  ExperimentParameters parameters = parametersFor(MethodKind::kPaper);
  parameters.trials = 100;
  const auto trials = runExperiment(
      barBehindPeg(), parameters, interrupted,
      [&](const ExperimentProgress& progress) { interrupted = interrupted || progress.finished; });
  EXPECT_GE(trials.size(), 1u);
  EXPECT_LT(trials.size(), 100u);
}

TEST(RunExperiment, aTrialThatBreaksCostsNoOther) {
  ExperimentParameters parameters = parametersFor(MethodKind::kPaper);
  parameters.trials = 3;
  parameters.max_collisions = 1;
  parameters.maps_directory = ::testing::TempDir() + "smore_broken_trial";
  std::filesystem::remove_all(parameters.maps_directory);
  std::filesystem::create_directories(parameters.maps_directory);
  std::ofstream(parameters.maps_directory + "/seed_2") << "a file where a directory should be";
  const auto trials =
      runExperiment(barBehindPeg(), parameters, kNotInterrupted, [](const auto&) {});
  std::filesystem::remove_all(parameters.maps_directory);
  ASSERT_EQ(trials.size(), 3u);
  EXPECT_FALSE(trials[0].broken);
  EXPECT_FALSE(trials[2].broken);
  EXPECT_TRUE(trials[1].broken);
  EXPECT_FALSE(trials[1].success);
  EXPECT_NE(trials[1].reason.find("seed_2"), std::string::npos) << trials[1].reason;
}

TEST(RunExperiment, reconstructsByTouchingUntilTheBudget) {
  Scenario scenario = barBehindPeg();
  scenario.task = Task::kReconstruct;
  scenario.reconstruct_touches = 5;
  ExperimentParameters parameters = parametersFor(MethodKind::kPaper);
  parameters.trials = 1;
  const auto trials = runExperiment(scenario, parameters, kNotInterrupted, [](const auto&) {});
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_TRUE(trials[0].success) << trials[0].reason;
  EXPECT_EQ(trials[0].collisions, 5);
}

}  // namespace
}  // namespace smore
