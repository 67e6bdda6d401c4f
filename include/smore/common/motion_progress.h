// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// A robot at its target is this near [m + rad] (gapBetween).
constexpr double kAtTarget = 2e-3;

enum class MotionStage {
  kUnderWay,
  kArrived,  ///< it stands at the target
  kStalled,  ///< it has stood short of the target for half a second
  kLate,     ///< it has taken far more than its time
};

/// Tells from poses how far a commanded motion has come. An arrival is a pose at the target that
/// stays, not before nine tenths of the motion's time: a path may cross its own end.
class MotionProgress {
 public:
  /// The motion begins at `time` [s] at the pose `here`; it should take `duration` [s].
  MotionProgress(double time, const Pose& here, const Pose& target, double duration);

  /// After a further pose; times [s] rise.
  MotionStage update(double time, const Pose& here);

  /// Way of the origin so far [m].
  double length() const { return length_; }

 private:
  double begin_;
  Pose target_;
  double duration_;
  Pose last_;
  double length_ = 0.0;
  Pose rest_pose_;  ///< where it was when it last moved
  double rest_since_;
};

}  // namespace smore
