// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_frames.h"

#include <ros/ros.h>

#include "smore/ros/conversions.h"

namespace smore {
namespace {

// Of the wall's clock, since a simulated one may stand. Our choice.
constexpr double kPatience = 1.0;     // for tf that comes later than the cloud [s]
constexpr double kLookPeriod = 0.01;  // between two looks [s]

}  // namespace

Result<Pose> CloudFrames::poseIn(const std::string& target, const std_msgs::Header& cloud) const {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  std::string problem;
  while (!transforms_.canTransform(target, cloud.frame_id, cloud.stamp, &problem)) {
    if (!ros::ok() || ros::WallTime::now() > deadline) return Failure{problem};
    problem.clear();
    ros::WallDuration(kLookPeriod).sleep();
  }
  return fromTransform(transforms_.lookupTransform(target, cloud.frame_id, cloud.stamp).transform);
}

}  // namespace smore
