// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "smore/common/geometry.h"

namespace smore {

/// The last stretch of the object's free motion, to say where it was going when it was stopped.
class MovementTrail {
 public:
  /// `step` [m], positive: length of the stretch; `lever` [m], not negative: what a radian counts
  /// in it. std::invalid_argument for others.
  MovementTrail(double step, double lever);

  /// The object stands free at a pose. One that is farther than a step from the last one begins a
  /// new motion: the object was put there.
  void record(const Pose& T_world_object);

  /// Where it would have come to, had a motion that is stopped at `T_world_object` gone on for as
  /// long as its last step. The pose itself where it has not moved for so much as that.
  Pose beyond(const Pose& T_world_object) const;

 private:
  double lengthBetween(const Pose& a, const Pose& b) const;

  double step_;
  double lever_;
  std::deque<Pose> poses_;  ///< the oldest at the front: the last that is a step away, if any
};

}  // namespace smore
