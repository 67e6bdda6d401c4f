// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/robot_frames.h"

namespace smore {

geometry_msgs::TransformStamped stampedTransform(const std::string& parent,
                                                 const std::string& child,
                                                 const Pose& T_parent_child,
                                                 const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform = toTransform(T_parent_child);
  return message;
}

geometry_msgs::TransformStamped baseTransform(const ArmMotion& arm, const Pose& T_world_base,
                                              const FrameNames& frames) {
  return stampedTransform(frames.world, arm.model().frames().base, T_world_base, ros::Time());
}

geometry_msgs::TransformStamped gripTransform(const ArmMotion& arm, const FrameNames& frames) {
  return stampedTransform(arm.model().frames().tool, frames.object, arm.T_tool_object(),
                          ros::Time());
}

}  // namespace smore
