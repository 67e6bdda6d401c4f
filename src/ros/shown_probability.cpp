// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/shown_probability.h"

#include "smore/ros/names.h"

namespace smore {

ShownProbability::ShownProbability(const ros::NodeHandle& node, double value)
    : value_(value), node_(node) {
  wish_ = node_.subscribe(names::kShownProbability, names::kLatestQueue, &ShownProbability::onWish,
                          this);
}

void ShownProbability::onWish(const std_msgs::Float64& message) {
  if (message.data > 0.0 && message.data <= 1.0) {
    value_ = message.data;
  } else {
    ROS_WARN_STREAM("'" << wish_.getTopic() << "' says " << message.data
                        << ": give a probability above 0 and up to 1");
  }
}

}  // namespace smore
