// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/InteractiveMarker.h>

#include <string>

#include "smore/ros/pose_knowledge.h"
#include "smore/scenario/motion_space.h"

namespace smore {

/// Name of the interactive marker that is the goal, and what a click on its menu means.
constexpr char kGoalMarkerName[] = "goal";
constexpr int kBackToTheTasksGoal = 1;  ///< menu_entry_id of its feedback

/// A goal, and what is known of it.
struct MarkedGoal {
  Pose T_world_goal = Pose::Identity();
  OccupiedVoxels object;  ///< in the object frame; none: nothing is known of its shape
  PoseAssessment assessment;
  std::string way;  ///< what is said of the way there; empty: nothing
};

/// The object as it is known, standing at the goal in the frame `world_frame`, to be dragged: in
/// planar motion by itself in its plane and by a ring about the plane's normal, else along and
/// about three axes. Its colour is that of the risk, or of what is not allowed; its text says both
/// in words, and what is said of the way.
visualization_msgs::InteractiveMarker goalMarkerMessage(const MarkedGoal& goal, Motion motion,
                                                        const std::string& world_frame);

}  // namespace smore
