// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>

#include "smore/common/geometry.h"

namespace smore {

/// Remembers where a fault stopped the robot until it has been moved from there: as long as it
/// stands there something may press, and the sensor must not be zeroed. Safe from any thread.
class FaultPlace {
 public:
  /// Takes where the object is and whether there is a fault now.
  void observe(const Pose& T_world_object, bool faulted) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (faulted && !faulted_) place_ = T_world_object;
    if (place_ && gapBetween(*place_, T_world_object) > kMoved) place_.reset();
    faulted_ = faulted;
  }

  /// Whether the object still is where the last fault found it.
  bool isHere() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return place_.has_value();
  }

 private:
  static constexpr double kMoved = 0.01;  ///< [m + rad]; no arm bends so far under a force that it
                                          ///< bears, so that this was a motion

  mutable std::mutex mutex_;
  std::optional<Pose> place_;
  bool faulted_ = false;
};

}  // namespace smore
