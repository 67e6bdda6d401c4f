// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/common/robot.h"

namespace smore {

/// Told of each motion that was planned, before it begins and when it has ended.
class MotionObserver {
 public:
  virtual ~MotionObserver() = default;

  /// `path` [T_world_object] will be followed next. `risk`: the probability that it touches, in
  /// [0, 1], where the planner states one.
  virtual void motionBegins(const Path& path, const std::optional<double>& risk) = 0;

  /// How it ended, and where the object is now.
  virtual void motionEnded(const MotionResult& result, const Pose& T_world_object) = 0;
};

}  // namespace smore
