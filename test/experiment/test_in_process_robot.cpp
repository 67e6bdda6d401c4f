// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "distance_to_line.h"
#include "peg_in_fork.h"
#include "smore/experiment/in_process_robot.h"
#include "smore/scenario/scenario.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {
namespace {

Scenario fork() {
  Scenario scenario = pegInFork();
  scenario.goal = makePose(Vec3(-0.4, 0, 0));
  scenario.workspace = {Vec3(-0.6, -0.4, -0.01), Vec3(0.2, 0.4, 0.01)};
  return scenario;
}

class InProcessRobotTest : public ::testing::Test {
 protected:
  Scenario scenario_ = fork();
  std::unique_ptr<SimulatedRobot> simulated_ = makeSimulatedRobot(scenario_, 1);
  ContactObservation newest_;
  InProcessRobot robot_{simulated_.get(), ContactSensingParameters{}, 1,
                        [this](const ContactObservation& observation) { newest_ = observation; }};
};

// Aslant along a prong the force rises slowly, so that a short way back still rubs.
TEST_F(InProcessRobotTest, retreatsUntilNothingTouches) {
  const Path aslant{makePose(Vec3(0, 0.004, 0)), makePose(Vec3(-0.09, 0.008, 0))};
  ASSERT_EQ(robot_.follow(aslant).end, MotionEnd::kContact);
  ASSERT_EQ(newest_.state, ContactState::kContact);
  const double hardly_any = 1e-4;
  const MotionResult back = robot_.retreat(hardly_any);
  EXPECT_EQ(back.end, MotionEnd::kReached) << back.reason;
  EXPECT_EQ(newest_.state, ContactState::kFree);
}

TEST_F(InProcessRobotTest, retreatsToTheBeginningAndNoFurther) {
  ASSERT_EQ(robot_.follow({makePose(Vec3(-0.05, 0, 0)), makePose(Vec3(-0.05, 0.1, 0))}).end,
            MotionEnd::kContact);
  for (int i = 0; i < 2; ++i) {
    const MotionResult back = robot_.retreat(1.0);
    EXPECT_EQ(back.end, MotionEnd::kReached) << back.reason;
    EXPECT_LT(gapBetween(robot_.pose(), scenario_.start), 0.003);
  }
}

// A bar of two metres that meets a post near its end: it swings back from the stop, and presses
// with no force for a moment.
TEST(InProcessRobot, feelsTheLineOfATouchWithTheEndOfALongBar) {
  Scenario scenario = fork();
  scenario.object = {{BoxShape{Vec3(0.2, 1.9, 0.17)}, Pose::Identity()}};
  scenario.environment = {{CylinderShape{0.06, 0.9}, makePose(Vec3(-0.3, 0.7, 0.0))}};
  scenario.goal = makePose(Vec3(-0.55, 0, 0));
  const auto simulated = makeSimulatedRobot(scenario, 1);
  std::vector<LineOfAction> lines;
  InProcessRobot robot(simulated.get(), ContactSensingParameters{}, 1,
                       [&lines](const ContactObservation& observation) {
                         if (observation.line) lines.push_back(*observation.line);
                       });
  ASSERT_EQ(robot.follow({scenario.goal}).end, MotionEnd::kContact);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT(distanceToLine(lines[0], Vec3(-0.1, 0.7, 0.0)), 0.005);
}

// Gripper and object weigh more than the least force of a contact.
TEST(InProcessRobot, takesNoWeightForAContactWhereAnArmTiltsIt) {
  Scenario scenario = loadScenario(SMORE_SOURCE_DIR "/config/scenarios/ur5e_one_peg_quiet.yaml");
  scenario.environment.resize(0);
  scenario.motion = Motion::kSpatial;
  scenario.workspace.max.z() = 0.5;
  scenario.start.translation() = Vec3(0.5, 0.0, 0.4);
  const auto simulated = makeSimulatedRobot(scenario, 1);
  ContactObservation newest;
  InProcessRobot robot(simulated.get(), sensingParameters(scenario, *simulated), 1,
                       [&newest](const ContactObservation& seen) { newest = seen; });
  const Pose tilted = scenario.start * Eigen::AngleAxisd(0.6, Vec3::UnitY());
  const MotionResult motion = robot.follow({scenario.start, tilted});
  EXPECT_EQ(motion.end, MotionEnd::kReached) << motion.reason;
  EXPECT_EQ(newest.state, ContactState::kFree);
  EXPECT_LT(robot.wrench().force.norm(), 0.5);
  EXPECT_LT(robot.wrench().torque.norm(), 0.1);
}

}  // namespace
}  // namespace smore
