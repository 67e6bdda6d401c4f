// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "smore/experiment/experiment.h"
#include "smore/kinematics/arm_motion.h"
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
                                           "ur10e_one_peg_quiet", "elbow_arm_one_peg_quiet",
                                           "ur5e_one_peg_in_space"),
                         [](const auto& scene) { return scene.param; });

// What touches from the beginning would end no motion.
TEST(ArmTrial, isRefusedWhereALinkTouchesAtTheStart) {
  Scenario scenario = loadScenario(SMORE_SOURCE_DIR "/config/scenarios/ur5e_one_peg_quiet.yaml");
  scenario.perturb = {};
  const ArmMotion motion(armUrdf(scenario), armMotionParameters(scenario));
  const auto q = motion.configurationFor(scenario.start);
  ASSERT_TRUE(q);
  const ArmModel& arm = motion.model();
  const Pose forearm = scenario.T_world_base *
                       arm.linkPoses(*q)[static_cast<size_t>(arm.tree().linkIndex("forearm_link"))];
  scenario.environment.push_back({SphereShape{0.03}, forearm * makePose(Vec3(-0.2, 0, 0))});
  const auto trials =
      runExperiment(scenario, ExperimentParameters(), kNotInterrupted, [](const auto&) {});
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_TRUE(trials[0].broken);
  EXPECT_NE(trials[0].reason.find("forearm_link touches the environment at the start"),
            std::string::npos)
      << trials[0].reason;
}

}  // namespace
}  // namespace smore
