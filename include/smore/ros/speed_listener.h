// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

#include <atomic>

namespace smore {

/// How fast the robot runs what it is commanded, by its driver.
class SpeedListener {
 public:
  /// Messages are taken by whoever calls `queue`.
  explicit SpeedListener(ros::CallbackQueue* queue);

  /// Share of full speed, 0 to 1; 1 until a driver has said another. From any thread.
  double scaling() const { return scaling_; }

 private:
  void onScaling(const std_msgs::Float64& message);

  std::atomic<double> scaling_{1.0};
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
};

}  // namespace smore
