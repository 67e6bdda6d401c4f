// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/speed_listener.h"

#include <algorithm>
#include <cmath>

#include "smore/ros/names.h"

namespace smore {

SpeedListener::SpeedListener(ros::CallbackQueue* queue) {
  node_.setCallbackQueue(queue);
  subscriber_ =
      node_.subscribe(names::kSpeedScaling, names::kLatestQueue, &SpeedListener::onScaling, this,
                      ros::TransportHints().tcpNoDelay());
}

void SpeedListener::onScaling(const std_msgs::Float64& message) {
  if (std::isfinite(message.data)) scaling_ = std::clamp(message.data, 0.0, 1.0);
}

}  // namespace smore
