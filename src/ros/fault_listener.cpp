// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/fault_listener.h"

#include "smore/ros/names.h"

namespace smore {

FaultListener::FaultListener(ros::CallbackQueue* queue) {
  node_.setCallbackQueue(queue);
  // All of them: one that is cleared at once would be lost behind the empty one.
  subscriber_ =
      node_.subscribe(names::kGuardFault, names::kStreamQueue, &FaultListener::onFault, this);
}

std::string FaultListener::fault() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return fault_;
}

std::string FaultListener::last() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

int FaultListener::count() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return count_;
}

void FaultListener::onFault(const std_msgs::String& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!message.data.empty() && message.data != fault_) {
    last_ = message.data;
    ++count_;
  }
  fault_ = message.data;
}

}  // namespace smore
