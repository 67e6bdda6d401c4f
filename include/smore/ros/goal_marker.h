// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <ros/ros.h>

#include <mutex>
#include <string>

#include "smore/ros/conversions.h"
#include "smore/ros/goal_marker_message.h"
#include "smore/ros/latest_job.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// The goal as an interactive marker `goal_marker`, at the scenario's goal until somebody drags it,
/// published as `marked_goal`. While it is dragged it shows the risk at each pose by what was known
/// last, without a wait for anybody; when it is taken hold of, the planner is asked to bring its
/// maps up to date, and when it is let go, for the way there, unless a retrieval is under way.
class GoalMarker {
 public:
  GoalMarker(const Scenario& scenario, const FrameNames& frames, const PoseKnowledge& knowledge);
  ~GoalMarker();

  /// What is known from now on; from any thread.
  void know(const PoseKnowledge& knowledge);

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedback;

  void onFeedback(const Feedback& feedback);
  void drag(const Feedback& feedback);
  void moveTo(const Pose& T_world_goal);
  void say(const Pose& T_world_goal, const std::string& way);
  void show();
  void askForMaps();
  void askForWay();
  bool retrieves() const;
  Pose pose() const;
  geometry_msgs::PoseStamped stamped(const Pose& T_world_goal) const;

  Scenario scenario_;
  FrameNames frames_;
  ros::NodeHandle node_;
  ros::Publisher marked_;

  mutable std::mutex mutex_;  ///< guards both below
  MarkedGoal goal_;           ///< but for its assessment
  PoseKnowledge knowledge_;

  LatestJob shower_, asker_;
  interactive_markers::InteractiveMarkerServer server_;  ///< the last: it calls what uses all above
};

}  // namespace smore
