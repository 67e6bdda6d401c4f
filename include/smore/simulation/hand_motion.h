// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// A pose that follows a path at constant speed: on each segment as fast as both limits allow.
class HandMotion {
 public:
  /// Speeds [m/s] and [rad/s], positive.
  HandMotion(const Pose& start, double linear_speed, double angular_speed);

  /// Replaces the motion: straight to the first pose of `path`, then along it. Empty: stays.
  void follow(const Path& path);

  /// Ends the motion here.
  void stop() { follow({}); }

  /// Sets the pose, at rest.
  void place(const Pose& pose);

  /// Whether the end of the path has not been reached.
  bool moving() const { return next_ < waypoints_.size(); }

  const Pose& pose() const { return pose_; }

  /// Moves on by `step` [s], not negative.
  void advance(double step);

 private:
  void beginSegment();

  double linear_speed_;
  double angular_speed_;
  Pose pose_;
  Path waypoints_;
  size_t next_ = 0;  ///< the waypoint that the present segment ends at
  Pose segment_start_;
  double segment_duration_ = 0.0;  ///< [s]
  double segment_time_ = 0.0;      ///< since its start [s]
};

}  // namespace smore
