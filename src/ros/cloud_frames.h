// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>

#include "smore/common/geometry.h"
#include "smore/common/result.h"

namespace smore {

/// Where the clouds of cameras are, by tf. Listens in a thread of its own.
class CloudFrames {
 public:
  /// Pose of the cloud's frame in `target` at the cloud's stamp; the newest where it has none. tf
  /// may come later than the cloud: waits a second for it. Otherwise the reason, as tf has it.
  Result<Pose> poseIn(const std::string& target, const std_msgs::Header& cloud) const;

 private:
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_};
};

}  // namespace smore
