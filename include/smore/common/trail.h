// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// The way that a robot has come, to go back along it.
class Trail {
 public:
  /// The robot sets out from `here`. Where it was moved there by other means, the way that it had
  /// come is no longer its way back, and is forgotten.
  void setOutFrom(const Pose& here);

  /// Notes where the robot is on its way on, unless it has hardly moved (2 mm plus radians) since.
  void record(const Pose& pose);

  /// Forgets the part that the robot has gone back along; `here` is a pose of its way back.
  void unwind(const Pose& here);

  /// The way back from `here`: the newest poses first, at least `distance` [m + rad] of it if there
  /// is so much; empty where the robot is back at the beginning.
  Path wayBack(const Pose& here, double distance) const;

  /// Whether the robot is at its newest pose, or has been moved away from it by other means.
  bool endsAt(const Pose& here) const;

  void clear() { poses_.clear(); }

 private:
  Path poses_;
};

}  // namespace smore
