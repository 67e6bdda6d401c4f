// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "smore/kinematics/wrist_sensor.h"

namespace smore {
namespace {

TEST(WristSensor, hasTheRangeThatTheMakerStates) {
  EXPECT_EQ(wristSensorRange(RobotKind::kUr3e).force, 30.0);
  EXPECT_EQ(wristSensorRange(RobotKind::kUr5e).force, 50.0);
  EXPECT_EQ(wristSensorRange(RobotKind::kUr10e).force, 100.0);
  EXPECT_EQ(wristSensorRange(RobotKind::kUr16e).force, 160.0);
  EXPECT_EQ(wristSensorRange(RobotKind::kUr5e).torque, 10.0);
  EXPECT_EQ(wristSensorRange(RobotKind::kUr16e).torque, 15.0);
  EXPECT_TRUE(std::isinf(wristSensorRange(RobotKind::kCartesian).force)) << "nothing limits it";
}

}  // namespace
}  // namespace smore
