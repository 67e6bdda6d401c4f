// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "smore/common/result.h"

namespace smore {

/// The newest positions of some joints on `joint_states`; safe to ask from any thread.
class JointListener {
 public:
  /// Messages are taken by `queue`, which must outlive this.
  JointListener(ros::CallbackQueue* queue, const std::vector<std::string>& joints);

  /// The positions in the order of the joints, not older than 0.1 s before `time` (a stamp) [s]:
  /// joints move by some millimetres in it. The reason where there are none.
  Result<std::vector<double>> positionsAt(double time) const;

 private:
  struct Positions {
    double time = 0.0;  ///< stamp [s]
    std::vector<double> values;
  };

  void onJoints(const sensor_msgs::JointState& message);

  std::vector<std::string> joints_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  mutable std::mutex mutex_;
  std::optional<Positions> newest_;  ///< guarded by mutex_
};

}  // namespace smore
