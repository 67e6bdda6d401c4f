// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace smore {

/// Lets a repeated log message through once a period of wall time. (roscpp's own throttling goes by
/// ROS time, which may stand still exactly when something is wrong.)
class Throttle {
 public:
  /// `period` [s], positive.
  explicit Throttle(double period) : period_(period) {}

  /// Whether a period has passed since this was last true; true at first.
  bool isDue() {
    const ros::WallTime now = ros::WallTime::now();
    if (!last_.isZero() && (now - last_).toSec() < period_) return false;
    last_ = now;
    return true;
  }

 private:
  double period_;
  ros::WallTime last_;
};

}  // namespace smore
