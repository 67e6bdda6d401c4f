// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval_monitor.h"

#include <algorithm>

#include "smore/common/result.h"
#include "smore/retrieval/evidence.h"
#include "smore/ros/conversions.h"
#include "smore/ros/goal_states.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

using Diagnostic = diagnostic_msgs::DiagnosticStatus;

constexpr double kOldStatus = 5.0;   // [s]: as the standard viewers have it
constexpr double kOldForce = 1.0;    // [s]
constexpr double kSamePlace = 1e-3;  // more than rounding, less than anybody drags [m + rad]

std::string phaseInWords(const std::string& phase) {
  static const std::map<std::string, std::string> words = {
      {"planning", "looking for a way"},
      {"moving", "moving along the way"},
      {"retreating", "backing off after a touch"},
      {"resetting", "going back to the start"},
      {"finished", "finishing"},
  };
  const auto found = words.find(phase);
  return found == words.end() ? phase : found->second;
}

std::string phaseOf(const RetrievalView& view, const std::string& phase) {
  if (!view.up) return "no retrieval node";
  if (!view.active) return "waiting for a goal";
  return phase.empty() ? "getting ready" : phaseInWords(phase);
}

/// Names of statuses begin with the namespace, without its first slash.
std::string statusPrefix(const std::string& space) {
  const std::string name = space.substr(1);
  return name.empty() ? "" : name + "/";
}

}  // namespace

std::string NodeStatus::value(const std::string& key, const std::string& otherwise) const {
  const auto found = values.find(key);
  return found == values.end() ? otherwise : found->second;
}

bool RetrievalView::wayLeadsToGoal() const {
  if (!goal || !way_end || goal->header.frame_id != way_end->header.frame_id) return false;
  const Result<Pose> wanted = fromMessage(goal->pose);
  const Result<Pose> shown = fromMessage(way_end->pose);
  return wanted && shown && gapBetween(*wanted, *shown) < kSamePlace;
}

RetrievalMonitor::RetrievalMonitor(const ros::NodeHandle& node)
    : node_(node), prefix_(statusPrefix(node.getNamespace())) {
  node_.setCallbackQueue(&queue_);
  subscribe();
  spinner_.start();
}

void RetrievalMonitor::subscribe() {
  constexpr std::uint32_t kQueue = 100;
  const std::string action = names::kRetrieve;
  status_ = node_.subscribe(action + "/status", kQueue, &RetrievalMonitor::onStatus, this);
  feedback_ = node_.subscribe(action + "/feedback", kQueue, &RetrievalMonitor::onFeedback, this);
  result_ = node_.subscribe(action + "/result", kQueue, &RetrievalMonitor::onResult, this);
  force_ = node_.subscribe(names::kWrenchCompensated, kQueue, &RetrievalMonitor::onForce, this);
  fault_ = node_.subscribe(names::kGuardFault, kQueue, &RetrievalMonitor::onFault, this);
  source_ = node_.subscribe(names::kEvidenceSource, names::kLatestQueue,
                            &RetrievalMonitor::onSource, this);
  marked_ =
      node_.subscribe(names::kMarkedGoal, names::kLatestQueue, &RetrievalMonitor::onMarked, this);
  path_ = node_.subscribe(names::kPath, names::kLatestQueue, &RetrievalMonitor::onPath, this);
  diagnostics_ = node_.subscribe("/diagnostics", kQueue, &RetrievalMonitor::onDiagnostics, this);
}

RetrievalView RetrievalMonitor::view() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::WallTime now = ros::WallTime::now();
  if (forces_ > 0) view_.force = (force_sum_ / forces_).norm();
  if ((now - last_force_).toSec() > kOldForce) view_.force.reset();
  force_sum_.setZero();
  forces_ = 0;
  view_.up = status_.getNumPublishers() > 0;
  view_.active = view_.active && view_.up;
  if (!view_.active) view_.risk.reset();  // nobody goes that way any more
  view_.phase = phaseOf(view_, phase_);
  view_.statuses.clear();
  for (const auto& [name, told] : told_) {
    NodeStatus& status = view_.statuses[name] = told.status;
    if ((now - told.at).toSec() < kOldStatus) continue;
    status.level = Diagnostic::STALE;
    status.message = "its node says nothing any more";
  }
  return view_;
}

void RetrievalMonitor::onStatus(const actionlib_msgs::GoalStatusArray& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto present = std::find_if(
      message.status_list.begin(), message.status_list.end(),
      [this](const auto& goal) { return isUnderWay(goal) && goal.goal_id.id != finished_; });
  view_.active = present != message.status_list.end();
  if (view_.active) beginGoal(present->goal_id.id);
}

// Topics come by connections of their own: whichever is first tells of a new goal.
void RetrievalMonitor::beginGoal(const std::string& goal) {
  if (goal == goal_) return;
  goal_ = goal;
  phase_.clear();
  view_.contacts = view_.plans = 0;
  view_.risk.reset();
}

void RetrievalMonitor::onFeedback(const smore_msgs::RetrieveActionFeedback& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string& goal = message.status.goal_id.id;
  if (goal == finished_) return;
  beginGoal(goal);
  view_.active = true;
  phase_ = message.feedback.phase;
  view_.contacts = message.feedback.collisions;
  view_.plans = message.feedback.plans;
  view_.risk = message.feedback.risk;
}

void RetrievalMonitor::onResult(const smore_msgs::RetrieveActionResult& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  finished_ = message.status.goal_id.id;
  beginGoal(finished_);
  view_.active = false;
  view_.contacts = message.result.collisions;
  view_.plans = message.result.plans;
  view_.succeeded = message.result.success != 0;
  view_.outcome = message.result.message;
}

void RetrievalMonitor::onFault(const std_msgs::String& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.fault = message.data;
}

void RetrievalMonitor::onMarked(const geometry_msgs::PoseStamped& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.goal = message;
}

void RetrievalMonitor::onPath(const nav_msgs::Path& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.way_end.reset();
  if (!message.poses.empty()) view_.way_end = message.poses.back();
}

void RetrievalMonitor::onForce(const geometry_msgs::WrenchStamped& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  force_sum_ += fromMessage(message.wrench).force;
  ++forces_;
  last_force_ = ros::WallTime::now();
}

void RetrievalMonitor::onSource(const smore_msgs::EvidenceSource& message) {
  try {
    const Scenario task = readEvidenceSource(message.records, names::kEvidenceSource).task;
    const std::lock_guard<std::mutex> lock(mutex_);
    view_.reconstructs = task.task == Task::kReconstruct;
  } catch (const InputError& error) {
    ROS_WARN_STREAM(error.what());
  }
}

void RetrievalMonitor::onDiagnostics(const diagnostic_msgs::DiagnosticArray& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const Diagnostic& said : message.status) {
    if (said.name.compare(0, prefix_.size(), prefix_) != 0) continue;
    NodeStatus status{said.level, said.message, {}};
    for (const diagnostic_msgs::KeyValue& pair : said.values) status.values[pair.key] = pair.value;
    told_[said.name.substr(prefix_.size())] = {std::move(status), ros::WallTime::now()};
  }
}

}  // namespace smore
