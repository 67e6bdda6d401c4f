// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/wrist_sensor.h"

namespace smore {

WrenchRange wristSensorRange(RobotKind kind) {
  switch (kind) {
    case RobotKind::kUr3e:
      return {30.0, 10.0};
    case RobotKind::kUr5e:
      return {50.0, 10.0};
    case RobotKind::kUr10e:
      return {100.0, 10.0};
    case RobotKind::kUr16e:
      return {160.0, 15.0};
    case RobotKind::kCartesian:
    case RobotKind::kUrdf:
      break;
  }
  return {};
}

}  // namespace smore
