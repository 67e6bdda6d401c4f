// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <functional>
#include <string>

#include "smore/ros/throttle.h"

namespace smore {

/// Level, message and values of one thing that a node watches of itself.
using Status = diagnostic_updater::DiagnosticStatusWrapper;

/// Tells on `/diagnostics` how a node fares, once a second of wall time: by ROS time, which
/// diagnostic_updater goes by, nothing would be told while a simulation stands still, and too much
/// where it runs fast.
class StatusPublisher {
 public:
  StatusPublisher() { updater_.setHardwareID("none"); }

  /// `compose` fills in the status `name` whenever it is due, in the thread that asks.
  void add(const std::string& name, const std::function<void(Status*)>& compose) {
    updater_.add(name, [compose](Status& status) { compose(&status); });
  }

  /// Publishes all statuses where a second has passed since it last did; from one thread at a time.
  void publishIfDue() {
    if (due_.isDue()) updater_.force_update();
  }

 private:
  static constexpr double kPeriod = 1.0;  // [s], of which the standard viewers wait five for more

  diagnostic_updater::Updater updater_;
  Throttle due_{kPeriod};
};

}  // namespace smore
