// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/goal_marker.h"

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/topic.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "smore/ros/goal_states.h"
#include "smore/ros/messages.h"
#include "smore/ros/names.h"
#include "smore/ros/plan_from_here.h"

namespace smore {
namespace {

constexpr bool kOwnThread = true;
constexpr bool kLatched = true;

std::string wordsFor(const Result<double>& risk) {
  std::ostringstream words;
  words << std::fixed << std::setprecision(2);
  if (risk) {
    words << "the way touches with probability " << *risk;
  } else {
    words << "no way: " << risk.reason();
  }
  return words.str();
}

}  // namespace

GoalMarker::GoalMarker(const Scenario& scenario, const FrameNames& frames,
                       const PoseKnowledge& knowledge)
    : scenario_(scenario), frames_(frames), server_(names::kGoalMarker, "", kOwnThread) {
  marked_ = node_.advertise<geometry_msgs::PoseStamped>(names::kMarkedGoal, names::kLatestQueue,
                                                        kLatched);
  know(knowledge);
  moveTo(scenario.goal);
}

// Jobs use the server, and the server's thread gives jobs.
GoalMarker::~GoalMarker() {
  asker_.end();
  shower_.end();
}

void GoalMarker::know(const PoseKnowledge& knowledge) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    knowledge_ = knowledge;
    goal_.object = knowledge.object;
  }
  shower_.give([this] { show(); });
}

// The server holds a lock of its own while it calls this, which `show` needs: no wait for that.
void GoalMarker::onFeedback(const Feedback& feedback) {
  switch (feedback.event_type) {
    case Feedback::MOUSE_DOWN:
      asker_.give([this] { askForMaps(); });
      break;
    case Feedback::POSE_UPDATE:
      drag(feedback);
      break;
    case Feedback::MOUSE_UP:
      drag(feedback);
      asker_.give([this] { askForWay(); });
      break;
    case Feedback::MENU_SELECT:
      if (feedback.menu_entry_id != kBackToTheTasksGoal) break;
      moveTo(scenario_.goal);
      asker_.give([this] { askForWay(); });
      break;
    default:
      break;
  }
}

void GoalMarker::drag(const Feedback& feedback) {
  geometry_msgs::PoseStamped stamped;
  stamped.header = feedback.header;
  stamped.pose = feedback.pose;
  const Result<Pose> pose = fromMessage(stamped, frames_.world);
  if (!pose) {
    ROS_WARN_STREAM("the goal stays where it is: " << pose.reason());
    return;
  }
  // A mouse leaves the plane of planar motion by its rounding.
  moveTo(scenario_.motionSpace().moved(*pose));
}

void GoalMarker::moveTo(const Pose& T_world_goal) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    goal_.T_world_goal = T_world_goal;
    goal_.way.clear();
  }
  marked_.publish(stamped(T_world_goal));
  shower_.give([this] { show(); });
}

void GoalMarker::say(const Pose& T_world_goal, const std::string& way) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (goal_.T_world_goal.matrix() != T_world_goal.matrix()) return;  // it has been moved on
    goal_.way = way;
  }
  shower_.give([this] { show(); });
}

void GoalMarker::show() {
  MarkedGoal goal;
  PoseKnowledge knowledge;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    goal = goal_;
    knowledge = knowledge_;
  }
  goal.assessment = knowledge.assess(goal.T_world_goal);
  server_.insert(goalMarkerMessage(goal, scenario_.motion, frames_.world),
                 [this](const auto& feedback) { onFeedback(*feedback); });
  server_.applyChanges();
}

/// Whoever answers it brings its maps up to date first, and so calls `know`.
void GoalMarker::askForMaps() {
  smore_msgs::CheckPose call;
  call.request.pose = stamped(pose());
  if (!ros::service::call(names::kCheckPose, call) || call.response.success == 0) {
    ROS_WARN_STREAM("the goal is shown by old maps: " << call.response.message);
  }
}

void GoalMarker::askForWay() {
  const Pose goal = pose();
  if (retrieves()) {
    say(goal, "the way there is looked for when no retrieval is under way");
    return;
  }
  say(goal, "looking for a way");
  say(goal, wordsFor(planFromHere(node_, stamped(goal))));
}

bool GoalMarker::retrieves() const {
  constexpr double kPatience = 0.5;  // status comes five times a second [s of ROS time]
  const auto status = ros::topic::waitForMessage<actionlib_msgs::GoalStatusArray>(
      std::string(names::kRetrieve) + "/status", ros::Duration(kPatience));
  return status && std::any_of(status->status_list.begin(), status->status_list.end(), isUnderWay);
}

Pose GoalMarker::pose() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goal_.T_world_goal;
}

geometry_msgs::PoseStamped GoalMarker::stamped(const Pose& T_world_goal) const {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = frames_.world;
  message.pose = toMessage(T_world_goal);
  return message;
}

}  // namespace smore
