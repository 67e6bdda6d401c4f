// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/hand_motion.h"

#include <algorithm>

namespace smore {

HandMotion::HandMotion(const Pose& start, double linear_speed, double angular_speed)
    : linear_speed_(linear_speed),
      angular_speed_(angular_speed),
      pose_(start),
      segment_start_(start) {}

void HandMotion::follow(const Path& path) {
  waypoints_ = path;
  next_ = 0;
  segment_start_ = pose_;
  segment_time_ = 0.0;
  if (moving()) beginSegment();
}

void HandMotion::place(const Pose& pose) {
  pose_ = pose;
  stop();
}

void HandMotion::beginSegment() {
  const Pose& end = waypoints_[next_];
  segment_duration_ = std::max(distanceBetween(segment_start_, end) / linear_speed_,
                               angleBetween(segment_start_, end) / angular_speed_);
}

void HandMotion::advance(double step) {
  if (!moving()) return;
  segment_time_ += step;
  while (segment_time_ >= segment_duration_) {
    segment_start_ = waypoints_[next_];
    segment_time_ -= segment_duration_;
    if (++next_ == waypoints_.size()) {
      pose_ = waypoints_.back();
      return;
    }
    beginSegment();
  }
  pose_ = interpolate(segment_start_, waypoints_[next_], segment_time_ / segment_duration_);
}

}  // namespace smore
