// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <smore/GuardConfig.h>

#include "dynamic_parameters.h"
#include "smore/contact/motion_guard.h"

namespace smore {

/// The guard's limits, which others may lower while it runs, and raise again up to what was
/// configured: more takes a person who starts the guard anew.
class GuardLimits {
 public:
  explicit GuardLimits(const MotionLimits& configured);

  /// What is in force; without waiting.
  MotionLimits now() const;

 private:
  DynamicParameters<GuardConfig> parameters_;
};

}  // namespace smore
