// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/fault_listener.h"

#include "smore/ros/names.h"

namespace smore {

FaultListener::FaultListener(ros::CallbackQueue* queue) {
  node_.setCallbackQueue(queue);
  subscriber_ =
      node_.subscribe(names::kGuardFault, names::kLatestQueue, &FaultListener::onFault, this);
}

std::string FaultListener::fault() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return fault_;
}

void FaultListener::onFault(const std_msgs::String& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  fault_ = message.data;
}

}  // namespace smore
