// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

#include <mutex>
#include <string>

namespace smore {

/// What the guard says on `guard/fault`; safe to ask from any thread.
class FaultListener {
 public:
  /// Messages are taken by `queue`, which must outlive this.
  explicit FaultListener(ros::CallbackQueue* queue);

  /// Why the guard lets nothing move; empty where it does, and where there is no guard.
  std::string fault() const;

  /// What it said last, cleared since or not; empty: nothing so far.
  std::string last() const;
  /// How often it has said something new that it had stopped the robot for.
  int count() const;

 private:
  void onFault(const std_msgs::String& message);

  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  mutable std::mutex mutex_;
  // Guarded by mutex_:
  std::string fault_;
  std::string last_;
  int count_ = 0;
};

}  // namespace smore
