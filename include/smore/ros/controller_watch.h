// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <string>

namespace smore {

/// Tells whether a robot's controller takes commands: one that is not loaded does not listen to
/// them, one that is loaded but stopped listens and drops them without a word. Controllers of
/// ros_controllers publish their state while they run, 50 times in a second or more; who publishes
/// none, as a simulator, is believed.
class ControllerWatch {
 public:
  /// Watches who gets `commands`. The state comes by whoever calls `queue`, from one thread, as
  /// `problem` is asked.
  ControllerWatch(ros::CallbackQueue* queue, const ros::Publisher& commands);

  /// Why a command would move nothing; empty where nothing says so. `now` [s of ros::SteadyTime]:
  /// all that had come by then must have been handed over.
  std::string problem(double now) const;

 private:
  ros::NodeHandle node_;
  ros::Publisher commands_;
  double last_state_ = ros::SteadyTime::now().toSec();
  double nobody_at_ = last_state_;  ///< when nobody told the state, for the last time
  ros::Subscriber state_;
  ros::SteadyTimer looks_;
};

}  // namespace smore
