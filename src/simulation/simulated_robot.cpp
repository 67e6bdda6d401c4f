// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/simulated_robot.h"

#include "arm_robot.h"
#include "cartesian_robot.h"
#include "smore/simulation/scene_check.h"

namespace smore {

std::unique_ptr<SimulatedRobot> makeSimulatedRobot(const Scenario& scenario, std::uint64_t seed,
                                                   double sensor_cutoff) {
  if (isArm(scenario.robot))
    return makeSimulatedArm(scenario, armUrdf(scenario), seed, sensor_cutoff);
  checkStartAndGoalFree(scenario);
  return std::make_unique<CartesianRobot>(scenario, seed, sensor_cutoff);
}

std::unique_ptr<SimulatedRobot> makeSimulatedArm(const Scenario& scenario, const UrdfModel& urdf,
                                                 std::uint64_t seed, double sensor_cutoff) {
  checkStartAndGoalFree(scenario);
  return std::make_unique<ArmRobot>(scenario, urdf, seed, sensor_cutoff);
}

}  // namespace smore
