// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// A robot at its target is this near [m + rad] (gapBetween).
constexpr double kAtTarget = 2e-3;

enum class MotionStage {
  kUnderWay,
  kArrived,  ///< it stands at the target; or within 1 cm and 0.05 rad of it when it would be late
  kStalled,  ///< it has stood short of the target for half a second, unpaused
  kLate,     ///< it has taken far more than its time
};

/// Tells from poses how far a commanded motion has come. An arrival is a pose at the target that
/// stays, not before nine tenths of the motion's time: a path may cross its own end. All waiting is
/// in the motion's own time, which passes at the share of full speed at which the robot runs: a
/// slow robot has longer, and in a pause nothing arrives, stalls or is late.
class MotionProgress {
 public:
  /// The motion begins at `time` [s] at the pose `here`; at full speed it should take `duration`
  /// [s].
  MotionProgress(double time, const Pose& here, const Pose& target, double duration);

  /// After a further pose; times [s] rise. `scaling`: share of full speed since the last one, 0 to
  /// 1; below kLeastScaling the robot is paused.
  MotionStage update(double time, const Pose& here, double scaling);

  /// The robot sets out again for the same target, which should take `duration` [s] at full speed.
  void setOutAgain(double duration);

  const Pose& target() const { return target_; }

  /// Way of the origin so far [m].
  double length() const { return length_; }

 private:
  bool isNearTarget(const Pose& here) const;

  double time_;  ///< of the last pose [s]
  Pose target_;
  double duration_;
  Pose last_;
  double length_ = 0.0;
  Pose rest_pose_;        ///< where it was when it last moved
  double elapsed_ = 0.0;  ///< since the begin, in the motion's own time [s]
  double rest_ = 0.0;     ///< since it last moved, in that time too [s]
};

}  // namespace smore
