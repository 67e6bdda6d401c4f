// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "smore/experiment/experiment.h"
#include "smore/scenario/scenario.h"

namespace smore {
namespace {

const std::atomic<bool> kNotInterrupted{false};

class ShippedArmScene : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedArmScene, endsWithTheObjectAtTheGoal) {
  const Scenario scenario =
      loadScenario(SMORE_SOURCE_DIR "/config/scenarios/" + GetParam() + ".yaml");
  ExperimentParameters parameters;
  parameters.max_collisions = 100;
  const auto trials = runExperiment(scenario, parameters, kNotInterrupted, [](const auto&) {});
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_TRUE(trials[0].success) << trials[0].reason;
  EXPECT_GT(trials[0].collisions, 0) << "the straight way is blocked";
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedArmScene,
                         ::testing::Values("ur3e_one_peg_quiet", "ur5e_one_peg_quiet",
                                           "ur10e_one_peg_quiet", "elbow_arm_one_peg_quiet"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace smore
