// SPDX-License-Identifier: BSD-3-Clause
#include "guard_limits.h"

#include "guard_parameters.h"

namespace smore {
namespace {

GuardConfig toConfig(const MotionLimits& limits) {
  GuardConfig config = GuardConfig::__getDefault__();
  config.max_force = limits.max_force;
  config.max_torque = limits.max_torque;
  config.max_joint_speed = limits.max_joint_speed;
  return config;
}

}  // namespace

GuardLimits::GuardLimits(const MotionLimits& configured)
    : parameters_(toConfig(configured), toConfig(kLeastLimits), toConfig(configured)) {}

MotionLimits GuardLimits::now() const {
  const GuardConfig config = parameters_.now();
  return {config.max_force, config.max_torque, config.max_joint_speed};
}

}  // namespace smore
