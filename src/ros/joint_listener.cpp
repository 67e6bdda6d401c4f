// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/joint_listener.h"

#include "smore/ros/conversions.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

constexpr double kOldest = 0.1;  // [s]

}  // namespace

JointListener::JointListener(ros::CallbackQueue* queue, const std::vector<std::string>& joints)
    : joints_(joints) {
  node_.setCallbackQueue(queue);
  subscriber_ = node_.subscribe(names::kJointStates, names::kLatestQueue, &JointListener::onJoints,
                                this, ros::TransportHints().tcpNoDelay());
}

// Others, such as a gripper, may publish joint states of their own on the same topic.
void JointListener::onJoints(const sensor_msgs::JointState& message) {
  const Result<std::vector<double>> positions = fromMessage(message, joints_);
  if (!positions) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_ = Positions{message.header.stamp.toSec(), *positions};
}

Result<std::vector<double>> JointListener::positionsAt(double time) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!newest_) {
    return Failure{"no joint states of the robot's joints on '" + subscriber_.getTopic() +
                   "'; is the robot's driver up?"};
  }
  const double age = time - newest_->time;
  if (age > kOldest) {
    return Failure{"the newest joint state is " + std::to_string(age) +
                   " s older than the newest wrench; is the robot's driver up?"};
  }
  return newest_->values;
}

}  // namespace smore
