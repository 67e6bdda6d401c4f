// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Path.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "smore/common/geometry.h"
#include "smore/ros/messages.h"

namespace smore {

/// How one thing that a node watches of itself fares, as it was last told on /diagnostics.
struct NodeStatus {
  int level = diagnostic_msgs::DiagnosticStatus::STALE;
  std::string message;
  std::map<std::string, std::string> values;

  /// A value as it was told; `otherwise` where it was not.
  std::string value(const std::string& key, const std::string& otherwise) const;
};

/// What is known of the nodes of one namespace and of their retrieval, all of one moment.
struct RetrievalView {
  bool up = false;      ///< whether a retrieval node is there
  bool active = false;  ///< whether it has a goal
  std::string phase;    ///< in words
  std::string outcome;  ///< how the last goal ended; empty: none has
  bool succeeded = false;
  unsigned contacts = 0, plans = 0;  ///< of the present goal, or the last one
  std::optional<double> risk;        ///< of the present plan of the present goal, in [0, 1]
  std::optional<double> force;       ///< mean since the last view, bias and weight taken off [N]
  std::string fault;          ///< why the guard lets nothing move; empty: it does, or is none
  bool reconstructs = false;  ///< whether the task is to reconstruct
  std::optional<geometry_msgs::PoseStamped> goal;     ///< that is marked, T_world_object
  std::optional<geometry_msgs::PoseStamped> way_end;  ///< of the last way that was shown
  std::map<std::string, NodeStatus> statuses;         ///< by "NODE: NAME"

  /// Whether the last way that was shown leads to the goal that is marked.
  bool wayLeadsToGoal() const;
};

/// Follows the topics of the nodes of one namespace, in a thread of its own.
class RetrievalMonitor {
 public:
  /// `node`: in the namespace of the nodes.
  explicit RetrievalMonitor(const ros::NodeHandle& node);

  /// What is known now.
  RetrievalView view();

 private:
  void subscribe();
  void onStatus(const actionlib_msgs::GoalStatusArray& message);
  void beginGoal(const std::string& goal);
  void onFeedback(const smore_msgs::RetrieveActionFeedback& message);
  void onResult(const smore_msgs::RetrieveActionResult& message);
  void onMarked(const geometry_msgs::PoseStamped& message);
  void onPath(const nav_msgs::Path& message);
  void onForce(const geometry_msgs::WrenchStamped& message);
  void onFault(const std_msgs::String& message);
  void onSource(const smore_msgs::EvidenceSource& message);
  void onDiagnostics(const diagnostic_msgs::DiagnosticArray& message);

  struct Told {
    NodeStatus status;
    ros::WallTime at;
  };

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::string prefix_;  ///< of the names of our nodes' statuses
  ros::Subscriber status_, feedback_, result_, force_, source_, fault_, diagnostics_, marked_,
      path_;

  std::mutex mutex_;  ///< guards all below
  RetrievalView view_;
  std::string goal_;      ///< identity of the present goal, or the last one
  std::string finished_;  ///< of the last goal that has ended
  std::string phase_;     ///< as the feedback has it; empty: none has come for the present goal
  Vec3 force_sum_ = Vec3::Zero();
  int forces_ = 0;
  ros::WallTime last_force_;
  std::map<std::string, Told> told_;

  ros::AsyncSpinner spinner_{1, &queue_};  ///< the last: it calls what uses all above
};

}  // namespace smore
