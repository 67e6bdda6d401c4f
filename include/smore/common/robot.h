// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "smore/common/geometry.h"

namespace smore {

/// How a commanded motion ended.
enum class MotionEnd {
  kReached,      ///< at the last pose of the path
  kContact,      ///< stopped by the contact reflex
  kUnreachable,  ///< the path leaves what the robot can do; it did not move
  kFault,        ///< the robot or a sensor failed; the reason says what
  kStopped,      ///< a user asked for the stop
};

struct MotionResult {
  MotionEnd end = MotionEnd::kReached;
  std::string reason;   ///< in words for the user; empty for kReached and kContact
  double length = 0.0;  ///< executed length of the object frame's origin [m]
  bool set_out = true;  ///< false: in contact before it began, so that it says nothing of its path
  /// T_world_object of the first place of the path where the robot cannot be; for kUnreachable.
  std::optional<Pose> refused_at = std::nullopt;
};

/// A robot that carries the object, as the retrieval loop knows it: simulated in this process,
/// behind ROS topics, or real. Contact stops it by its own reflex, not by a round trip through the
/// loop.
class Robot {
 public:
  virtual ~Robot() = default;

  /// T_world_object now.
  virtual Pose pose() const = 0;

  /// Follows `path` (T_world_object, its first pose is near the present one) at the configured
  /// speed; returns when it ended. Each observation made on the way has reached the maps when it
  /// returns.
  virtual MotionResult follow(const Path& path) = 0;

  /// Moves back along the way it came, at least `distance` [m + rad] if there is so much of it, and
  /// on until nothing touches. Touching on the way does not stop it: it moves where it has been.
  virtual MotionResult retreat(double distance) = 0;

  /// Brings the object to `start` without touching (the simulator sets it there; a real arm
  /// retreats along its whole way).
  virtual MotionResult reset(const Pose& start) = 0;
};

}  // namespace smore
