// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/simulated_robot.h"

#include "cartesian_robot.h"
#include "smore/common/result.h"
#include "smore/simulation/scene_check.h"

namespace smore {

std::unique_ptr<SimulatedRobot> makeSimulatedRobot(const Scenario& scenario, std::uint64_t seed) {
  if (scenario.robot != RobotKind::kCartesian) {
    throw InputError("scenario " + scenario.name +
                     ": robot: only 'cartesian' is simulated so far; use robot: cartesian");
  }
  checkStartAndGoalFree(scenario);
  return std::make_unique<CartesianRobot>(scenario, seed);
}

}  // namespace smore
