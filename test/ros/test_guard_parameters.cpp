// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "../../src/ros/guard_parameters.h"

namespace smore {
namespace {

MotionLimits fitted(RobotKind robot, GuardParameters parameters = {}) {
  Scenario scenario;
  scenario.robot = robot;
  fitToSensor(scenario, &parameters);
  return parameters.guard.limits;
}

TEST(GuardParameters, keepsCeilingsWithinEightTenthsOfTheSensorsRange) {
  EXPECT_DOUBLE_EQ(fitted(RobotKind::kUr3e).max_force, 24.0);
  EXPECT_DOUBLE_EQ(fitted(RobotKind::kUr5e).max_force, 40.0);
  EXPECT_DOUBLE_EQ(fitted(RobotKind::kUr5e).max_torque, 8.0);
}

TEST(GuardParameters, allowsNoMoreBecauseASensorCouldMeasureIt) {
  EXPECT_DOUBLE_EQ(fitted(RobotKind::kUr16e).max_force, MotionLimits().max_force);
  EXPECT_DOUBLE_EQ(fitted(RobotKind::kUrdf).max_torque, MotionLimits().max_torque);
}

TEST(GuardParameters, takesCeilingsThatWereGivenAsTheyAre) {
  GuardParameters given;
  given.guard.limits.max_force = 28.0;
  given.sets_force = true;
  EXPECT_DOUBLE_EQ(fitted(RobotKind::kUr3e, given).max_force, 28.0);
  EXPECT_DOUBLE_EQ(fitted(RobotKind::kUr3e, given).max_torque, 8.0);
}

TEST(GuardParameters, knowsByTheNoiseWhetherASensorThatRepeatsItselfIsFrozen) {
  Scenario scenario;
  GuardParameters parameters;
  scenario.wrench_noise = WrenchNoise();
  scenario.wrench_noise.force_stddev = scenario.wrench_noise.torque_stddev = 0.0;
  fitToSensor(scenario, &parameters);
  EXPECT_FALSE(parameters.guard.wrench_varies);
  scenario.wrench_noise.torque_stddev = 0.01;
  fitToSensor(scenario, &parameters);
  EXPECT_TRUE(parameters.guard.wrench_varies);
}

}  // namespace
}  // namespace smore
