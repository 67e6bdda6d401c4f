// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>

#include "smore/common/geometry.h"
#include "smore/ros/press_watch.h"

namespace smore {

/// What an observation says of a robot that a fault may have stopped.
struct FaultSign {
  double time = 0.0;  ///< [s]
  Pose T_world_object = Pose::Identity();
  bool faulted = false;
  bool presses = false;  ///< or pressed when that was last known
};

/// Remembers where a fault stopped the robot while something pressed, until it has been moved from
/// there: as long as it stands there, what presses must not be zeroed. Safe from any thread.
class FaultPlace {
 public:
  void observe(const FaultSign& sign) {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_ = sign;
    if (sign.faulted && !faulted_) {
      const Place last = place_.value_or(Place{});
      place_ = {sign.time, sign.T_world_object, last.pressed, last.zeroed};
    }
    faulted_ = sign.faulted;
    if (!place_) return;
    place_->pressed = place_->pressed || sign.presses;
    const bool stands = sign.time - place_->since > PressWatch::kComesToRest;
    const bool moved = gapBetween(place_->T_world_object, sign.T_world_object) > kMoved;
    if (moved || (stands && !place_->pressed)) place_.reset();
  }

  /// The robot's program, which had ended, starts, at which a UR zeroes its sensor. `met`: what
  /// presses, if anything does, was met on the way, and is no weight that was just gripped. That
  /// the program had ended is a fault then, be it told as one or not.
  void onProgramStart(bool met) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!last_ || !last_->presses) return;
    if (met && !place_) place_ = {last_->time, last_->T_world_object, true, false};
    if (place_) place_->zeroed = true;
  }

  /// Whether the object still is there, and the sensor was zeroed under what presses there.
  bool isZeroed() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return place_ && place_->zeroed;
  }

  /// Whether the object still is where the last such fault found it.
  bool isHere() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return place_.has_value();
  }

 private:
  struct Place {
    double since = 0.0;  ///< [s]
    Pose T_world_object = Pose::Identity();
    bool pressed = false;
    bool zeroed = false;
  };

  static constexpr double kMoved = 0.01;  ///< [m + rad]; no arm bends so far under a force that it
                                          ///< bears, so that this was a motion

  mutable std::mutex mutex_;
  std::optional<FaultSign> last_;
  std::optional<Place> place_;
  bool faulted_ = false;
};

}  // namespace smore
