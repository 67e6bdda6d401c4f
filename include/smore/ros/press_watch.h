// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>

#include "smore/contact/contact_observation.h"

namespace smore {

/// Whether something presses, and whether the robot met it on its way or it came by itself, as the
/// weight of what has just been gripped does. Safe from any thread.
class PressWatch {
 public:
  /// What a robot runs into as it stops is felt by then [s].
  static constexpr double kComesToRest = 1.0;

  /// `time` [s] of an observation. One that is unsure changes nothing: a sensor that is not tared,
  /// or feels hardly anything, is no sign.
  void observe(double time, ContactState state) {
    const std::lock_guard<std::mutex> lock(mutex_);
    time_ = time;
    if (state == ContactState::kContact) presses_ = true;
    if (state != ContactState::kFree) return;
    presses_ = false;
    if (failed_at_ && time > *failed_at_ + kComesToRest) failed_at_.reset();
  }

  /// A motion begins.
  void setOut() {
    const std::lock_guard<std::mutex> lock(mutex_);
    has_set_out_ = true;
  }

  /// A goal has ended. What presses from then on, until the object is free, was met on the way if
  /// the goal failed in its motions.
  void endGoal(bool success) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!success && has_set_out_) failed_at_ = time_;
    has_set_out_ = false;
  }

  /// Whether something pressed when that was last known.
  bool presses() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return presses_;
  }

  /// The same of what the robot met on its way.
  bool pressesFromTheWay() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return presses_ && failed_at_;
  }

 private:
  mutable std::mutex mutex_;
  double time_ = 0.0;  ///< of the newest observation [s]
  bool presses_ = false;
  bool has_set_out_ = false;         ///< since the last goal's end
  std::optional<double> failed_at_;  ///< when a goal failed in its motions [s]
};

}  // namespace smore
