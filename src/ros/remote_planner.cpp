// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/remote_planner.h"

#include "smore/ros/conversions.h"
#include "smore/ros/interruptible_call.h"
#include "smore/ros/messages.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

geometry_msgs::PoseStamped stamped(const Pose& pose, const std::string& frame) {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = frame;
  message.pose = toMessage(pose);
  return message;
}

// A node that is started again needs seconds: who asks again and again waits so long for it [s].
constexpr double kRestart = 1.0;

Failure noAnswer(const std::string& service) {
  return Failure{"the service '" + service + "' does not answer; is the planner node up?"};
}

}  // namespace

RemotePlanner::RemotePlanner(const std::string& world_frame, const RosRobot* robot)
    : world_frame_(world_frame), robot_(robot) {
  client_ = node_.serviceClient<smore_msgs::PlanPath>(names::kPlanPath);
}

bool RemotePlanner::waitUntilReady(double timeout) {
  return waitForService(&client_, timeout, [this] { return robot_->stopRequested(); });
}

Result<Plan> RemotePlanner::plan(const Pose& start, const Pose& goal) {
  return ask(start, goal, false);
}

Result<Plan> RemotePlanner::planRelaxed(const Pose& start, const Pose& goal) {
  return ask(start, goal, true);
}

Result<Plan> RemotePlanner::ask(const Pose& start, const Pose& goal, bool relaxed) {
  smore_msgs::PlanPath call;
  call.request.start = stamped(start, world_frame_);
  call.request.goal = stamped(goal, world_frame_);
  call.request.relaxed = static_cast<unsigned char>(relaxed);
  call.request.not_before.fromSec(robot_->stamp());
  for (const Pose& pose : refused_) call.request.refused.push_back(toMessage(pose));
  const auto given_up = [this] { return robot_->stopRequested(); };
  outage_ = noAnswer(client_.getService()).reason;
  if (!callInterruptibly(client_, &call, given_up)) {
    (void)waitUntilReady(kRestart);
    return Failure{outage_};
  }
  outage_ = call.response.searched != 0 ? "" : call.response.message;
  if (call.response.success == 0) return Failure{call.response.message};
  const Result<Path> path = fromMessage(call.response.path);
  if (!path) return Failure{path.reason()};
  return Plan{*path, call.response.risk};
}

RemoteTouchPlanner::RemoteTouchPlanner(const std::string& world_frame, const RosRobot* robot)
    : world_frame_(world_frame), robot_(robot) {
  client_ = node_.serviceClient<smore_msgs::PlanTouch>(names::kPlanTouch);
}

Result<Path> RemoteTouchPlanner::nextTouch(const Pose& from) {
  smore_msgs::PlanTouch call;
  call.request.start = stamped(from, world_frame_);
  call.request.not_before.fromSec(robot_->stamp());
  const auto given_up = [this] { return robot_->stopRequested(); };
  if (!callInterruptibly(client_, &call, given_up)) return noAnswer(client_.getService());
  if (call.response.enough != 0) return Path();
  if (call.response.success == 0) return Failure{call.response.message};
  return fromMessage(call.response.path);
}

}  // namespace smore
