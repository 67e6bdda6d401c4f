// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <std_msgs/Float64.h>

#include <atomic>

namespace smore {

/// From which probability on voxels are shown, as somebody who looks at them wants it on the topic
/// `shown_probability`; from any thread.
class ShownProbability {
 public:
  /// `value`: until somebody says another. The queue of `node` is called by who serves it.
  ShownProbability(const ros::NodeHandle& node, double value);

  /// In (0, 1].
  double value() const { return value_; }

 private:
  void onWish(const std_msgs::Float64& message);

  std::atomic<double> value_;
  ros::NodeHandle node_;
  ros::Subscriber wish_;
};

}  // namespace smore
