// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/sensor_zero.h"

#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "smore/ros/conversions.h"
#include "smore/ros/interruptible_call.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

constexpr int kAveraged = 200;         // samples: 0.4 s at 500 Hz ...
constexpr int kLeastAveraged = 20;     // ... or so many where that takes longer than ...
constexpr double kLongestBatch = 0.4;  // ... this [s of wall time]: 50 Hz give as many
constexpr double kNearZero = 0.5;      // [N]; what a zeroing that comes later still could change
constexpr double kDeviations = 2.0;    // of the mean's noise, on top of it: 99 % of means
constexpr double kLookPeriod = 0.1;    // [s of wall time]
// A zeroing shows by then, or the object swung in it and it is repeated [s of wall time].
constexpr double kPatience = 1.5;

/// Means of the raw wrench's force, over one batch of samples after the other.
class RawForce {
 public:
  explicit RawForce(ros::NodeHandle* node) {
    ros::SubscribeOptions options = ros::SubscribeOptions::create<geometry_msgs::WrenchStamped>(
        names::kWrench, names::kStreamQueue,
        [this](const geometry_msgs::WrenchStampedConstPtr& message) {
          add(fromMessage(message->wrench).force);
        },
        ros::VoidPtr(), &queue_);
    subscriber_ = node->subscribe(options);
  }

  /// Waits until a whole batch that began after the call is near zero; false after `timeout` [s of
  /// wall time], and where it is given up.
  bool comesToZero(double timeout, const std::function<bool()>& given_up) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
    near_zero_ = false;
    queue_.callAvailable();
    begin();
    while (ros::ok() && !given_up() && !near_zero_ && ros::WallTime::now() < deadline) {
      queue_.callAvailable(ros::WallDuration(kLookPeriod));
    }
    return near_zero_;
  }

  /// Of the last whole batch [N]; nothing where none came.
  std::optional<double> mean() const { return mean_; }

 private:
  void begin() {
    begun_ = ros::WallTime::now();
    sum_ = Vec3::Zero();
    squares_ = 0.0;
    count_ = 0;
  }

  void add(const Vec3& force) {
    sum_ += force;
    squares_ += force.squaredNorm();
    ++count_;
    const bool is_long = (ros::WallTime::now() - begun_).toSec() >= kLongestBatch;
    if (count_ < (is_long ? kLeastAveraged : kAveraged)) return;
    const Vec3 mean = sum_ / count_;
    const double variance = std::max(0.0, squares_ / count_ - mean.squaredNorm());
    mean_ = mean.norm();
    near_zero_ = *mean_ <= kNearZero + kDeviations * std::sqrt(variance / count_);
    begin();
  }

  ros::CallbackQueue queue_;
  ros::Subscriber subscriber_;
  Vec3 sum_ = Vec3::Zero();
  double squares_ = 0.0;
  int count_ = 0;
  ros::WallTime begun_;
  std::optional<double> mean_;
  bool near_zero_ = false;
};

/// Why a service did not do what it is for; empty where it did.
std::string demand(ros::NodeHandle* node, const std::string& name, double timeout,
                   const std::function<bool()>& given_up) {
  ros::ServiceClient client = node->serviceClient<std_srvs::Trigger>(name);
  std_srvs::Trigger call;
  const std::string service = "the service '" + client.getService() + "'";
  if (!waitForService(&client, timeout, given_up)) {
    return service + " does not appear; is its node up?";
  }
  if (!callInterruptibly(client, &call, given_up)) return service + " gave no answer";
  if (call.response.success != 0) return "";
  return service + " failed: " + call.response.message;
}

}  // namespace

std::string zeroSensor(ros::NodeHandle* node, const std::string& zero_service, double timeout,
                       const std::function<bool()>& given_up) {
  RawForce force(node);
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  bool zeroed = false;
  while (!zeroed && ros::ok() && !given_up() && ros::WallTime::now() < deadline) {
    // Else the zeroing would be a contact. The listener knows a weight that has just been gripped
    // from what presses, which would be taken for nothing from now on.
    std::string problem = demand(node, names::kListenerSuspend, timeout, given_up);
    if (!problem.empty()) return problem;
    problem = demand(node, zero_service, timeout, given_up);
    if (!problem.empty()) return problem;
    zeroed = force.comesToZero(std::min(kPatience, timeout), given_up);
  }
  if (!zeroed) {
    std::ostringstream reason;
    reason << "the service '" << node->resolveName(zero_service)
           << "' says that it has zeroed the sensor, but ";
    if (force.mean()) {
      reason << "the raw force is " << *force.mean() << " N; does the object hang free?";
    } else {
      reason << "fewer than " << kLeastAveraged << " wrenches came in " << kPatience << " s on '"
             << node->resolveName(names::kWrench) << "'; is the sensor's driver up?";
    }
    return reason.str();
  }
  return demand(node, names::kListenerTare, timeout, given_up);
}

}  // namespace smore
