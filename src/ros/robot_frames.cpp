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

std::vector<geometry_msgs::TransformStamped> gripTransforms(const ArmMotion& arm,
                                                            const Pose& T_world_base,
                                                            const FrameNames& frames) {
  const ArmFrames& names = arm.model().frames();
  return {stampedTransform(frames.world, names.base, T_world_base, ros::Time()),
          stampedTransform(names.tool, frames.object, arm.T_tool_object(), ros::Time())};
}

}  // namespace smore
