// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace smore {

/// Tells time that leaps (a recording begins again, a simulator does, a sensor was silent) from one
/// stamp that is wrong: a message whose stamp is more than `kLeap` from the newest, and far more
/// than that one was from the one before, is held back until the next one. Where that is nearer to
/// it than to the newest before, both are let through; otherwise the one that was held is dropped.
/// Where no other comes for `kPatience`, it is let through. `Message` has a header with a stamp.
template <typename Message>
class LeapFilter {
 public:
  static constexpr double kLeap = 1.0;      ///< [s]; most streams come many times a second
  static constexpr double kSlow = 3.0;      ///< a leap is more than so many gaps of a slow stream
  static constexpr double kPatience = 0.2;  ///< [s] of wall time: most streams go on sooner

  /// What is to be handled now, in order.
  std::vector<Message> take(const Message& message) {
    std::vector<Message> through;
    if (held_ && distance(message, *held_) < std::abs(secondsOf(message) - newest_)) {
      through.push_back(believe(*held_));
    } else if (held_) {
      ++dropped_;
    }
    held_.reset();
    if (begun_ && std::abs(secondsOf(message) - newest_) > std::max(kLeap, kSlow * gap_)) {
      held_ = message;
      held_since_ = ros::WallTime::now();
    } else {
      through.push_back(believe(message));
    }
    return through;
  }

  /// What was held back for so long that nothing else seems to come, else nothing.
  std::optional<Message> overdue() {
    if (!held_ || (ros::WallTime::now() - held_since_).toSec() < kPatience) return std::nullopt;
    (void)believe(*held_);
    return std::exchange(held_, std::nullopt);
  }

  /// Messages that were dropped, since the beginning.
  std::uint64_t dropped() const { return dropped_; }

 private:
  // In seconds: a duration does not hold the difference of any two times.
  static double secondsOf(const Message& message) { return message.header.stamp.toSec(); }
  static double distance(const Message& a, const Message& b) {
    return std::abs(secondsOf(a) - secondsOf(b));
  }

  const Message& believe(const Message& message) {
    gap_ = begun_ ? std::abs(secondsOf(message) - newest_) : 0.0;
    newest_ = secondsOf(message);
    begun_ = true;
    return message;
  }

  std::optional<Message> held_;
  ros::WallTime held_since_;
  double newest_ = 0.0;  ///< stamp of the last that was let through [s]
  double gap_ = 0.0;     ///< between that and the one before [s]
  bool begun_ = false;
  std::uint64_t dropped_ = 0;
};

}  // namespace smore
