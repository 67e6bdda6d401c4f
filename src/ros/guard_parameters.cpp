// SPDX-License-Identifier: BSD-3-Clause
#include "guard_parameters.h"

#include <algorithm>

#include "smore/kinematics/wrist_sensor.h"

namespace smore {

GuardParameters readGuardParameters(ParameterReader* reader) {
  constexpr double kMost = 1000.0;
  // From 0.3 rad/s an arm then stops within 0.15 s; a gentler stop runs on into what was touched.
  constexpr double kLeastDeceleration = 2.0;
  GuardParameters all;
  MotionGuardParameters& parameters = all.guard;
  MotionLimits& limits = parameters.limits;
  all.sets_force = reader->has("max_force");
  all.sets_torque = reader->has("max_torque");
  if (all.sets_force)
    reader->number("max_force", &limits.max_force, {kLeastLimits.max_force, kMost});
  if (all.sets_torque) {
    reader->number("max_torque", &limits.max_torque, {kLeastLimits.max_torque, kMost});
  }
  reader->number("max_lateness", &parameters.max_lateness, {0.005, 10.0});
  reader->number("max_silence", &parameters.max_silence, {0.005, 10.0});
  reader->number("max_joint_speed", &limits.max_joint_speed, {kLeastLimits.max_joint_speed, 10.0});
  reader->number("force_margin", &parameters.force_margin, {0.0, kMost});
  reader->number("torque_margin", &parameters.torque_margin, {0.0, kMost});
  reader->number("path_tolerance", &parameters.path_tolerance, {0.001, 1.0});
  reader->number("stop_deceleration", &all.horizon.deceleration, {kLeastDeceleration, kMost});
  if (parameters.max_silence < parameters.max_lateness) {
    reader->error("max_silence", "is less than max_lateness; give at least as much");
  }
  return all;
}

void fitToSensor(const Scenario& scenario, GuardParameters* parameters) {
  constexpr double kShare = 0.8;
  MotionGuardParameters& guard = parameters->guard;
  const WrenchNoise& noise = scenario.wrench_noise;
  guard.wrench_varies = noise.force_stddev > 0.0 || noise.torque_stddev > 0.0;
  const WrenchRange range = wristSensorRange(scenario.robot);
  MotionLimits& limits = guard.limits;
  if (!parameters->sets_force) limits.max_force = std::min(limits.max_force, kShare * range.force);
  if (!parameters->sets_torque) {
    limits.max_torque = std::min(limits.max_torque, kShare * range.torque);
  }
}

}  // namespace smore
