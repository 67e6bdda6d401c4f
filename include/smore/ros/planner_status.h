// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <mutex>
#include <optional>
#include <string>

#include "smore/ros/status_publisher.h"

namespace smore {

/// Keeps how long plans took, with the wait for maps that are new enough, and what became of the
/// last one, and composes the planner's status `plans` of it: WARN where the last one was refused.
/// Safe to use from any thread: it is asked while a plan is being made.
class PlannerStatus {
 public:
  /// A plan is being made from now on.
  void begin();

  /// It was found: its length [m] and risk, in [0, 1]; a motion that is meant to touch has none.
  void find(double length, std::optional<double> risk);

  /// There is none, for this reason.
  void refuse(const std::string& reason);

  void compose(Status* status) const;

 private:
  /// The plan that was being made has come or is refused; `mutex_` is held.
  void end();
  double sinceBegin() const { return (ros::WallTime::now() - begun_).toSec(); }

  mutable std::mutex mutex_;  ///< guards all below
  bool planning_ = false;
  ros::WallTime begun_;  ///< the plan that is being made, or the last one
  int found_ = 0, refused_ = 0;
  double last_ = 0.0, longest_ = 0.0;    ///< wall time that plans took [s]
  std::optional<double> length_, risk_;  ///< of the last one that was found
  std::string reason_;                   ///< why the last one was refused; empty: it was not
};

}  // namespace smore
