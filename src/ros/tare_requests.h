// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "smore/contact/contact_sensing.h"
#include "smore/ros/sensing_request.h"

namespace smore {

/// What services ask of the sensor's bias, done between two samples: a tare, and that nothing be
/// claimed because the driver is about to zero the sensor. Such a step in the signal would be a
/// contact else. Whoever says so may be cancelled before it tares: after 3 s a tare begins by
/// itself, as soon as nothing speaks against it.
class TareRequests {
 public:
  /// For the threads that ask; each waits for its answer.
  SensingRequest& tare() { return tare_; }
  SensingRequest& suspension() { return suspension_; }

  /// Does what was asked for, before the sample of `time` [s] is processed. The kind of
  /// smore/SensingEvent that it was, if any. Both are refused while something presses, but for a
  /// weight that the driver is to zero.
  std::optional<std::uint8_t> apply(double time, ContactSensing* sensing);

  /// Whether nothing is claimed because the sensor is about to be zeroed.
  bool suspended() const { return suspended_until_ || by_itself_; }

  /// Whether a tare is to begin that has not.
  bool tareWaits() const { return asked_at_ || by_itself_; }

  /// Forgets what has not begun.
  void forget();

 private:
  std::optional<std::uint8_t> suspend(double time, ContactSensing* sensing);
  std::optional<std::uint8_t> begin(double time, ContactSensing* sensing);

  SensingRequest tare_, suspension_;
  std::optional<double> asked_at_;          ///< for a tare [s]
  bool by_itself_ = false;                  ///< a suspension has ended without a tare
  std::optional<double> zeroing_asked_at_;  ///< for a suspension [s]
  std::optional<double> suspended_until_;   ///< [s]
};

}  // namespace smore
