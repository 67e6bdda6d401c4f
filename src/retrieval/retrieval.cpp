// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/retrieval.h"

#include <sstream>
#include <utility>

#include "smore/common/elapsed_time.h"

namespace smore {
RetrievalParameters retrievalParameters(const Scenario& scenario) {
  RetrievalParameters parameters;
  parameters.start = scenario.start;
  parameters.goal = scenario.goal;
  parameters.goal_position_tolerance = scenario.goal_position_tolerance;
  parameters.goal_angle_tolerance = scenario.goal_angle_tolerance;
  parameters.motion = scenario.motion;
  parameters.on_contact = scenario.on_contact;
  return parameters;
}

const char* phaseName(Phase phase) {
  switch (phase) {
    case Phase::kPlanning:
      return "planning";
    case Phase::kMoving:
      return "moving";
    case Phase::kResetting:
      return "resetting";
    case Phase::kRetreating:
      return "retreating";
    case Phase::kFinished:
      return "finished";
  }
  return "unknown";
}

Retrieval::Retrieval(const RetrievalParameters& parameters, Robot* robot, Planner* planner,
                     ProgressCallback on_progress, MotionObserver* motions)
    : parameters_(parameters),
      robot_(robot),
      planner_(planner),
      on_progress_(std::move(on_progress)),
      motions_(motions) {}

RetrievalOutcome Retrieval::run() {
  outcome_ = {};
  progress_ = {};
  calibration_ = RiskCalibration(parameters_.motion);
  refused_ = 0;
  refused_at_.clear();
  missed_ = 0;
  Plan plan;
  if (atGoal()) {
    finish(true, "the object was at the goal already");
    enter(Phase::kFinished);
    return outcome_;
  }
  while (findPlan(&plan) && !execute(plan)) {
  }
  outcome_.collisions = progress_.collisions;
  outcome_.plans = progress_.plans;
  enter(Phase::kFinished);
  return outcome_;
}

bool isAtGoal(const RetrievalParameters& parameters, const Pose& T_world_object) {
  return distanceBetween(T_world_object, parameters.goal) <= parameters.goal_position_tolerance &&
         angleBetween(T_world_object, parameters.goal) <= parameters.goal_angle_tolerance;
}

bool Retrieval::atGoal() const { return isAtGoal(parameters_, robot_->pose()); }

std::string Retrieval::missedGoal() const {
  const Pose end = robot_->pose();
  std::ostringstream text;
  text << "the robot ended " << missed_ << " motions in a row beside the goal, the last one "
       << distanceBetween(end, parameters_.goal) << " m and " << angleBetween(end, parameters_.goal)
       << " rad away; the goal_tolerance must be wider than the robot is accurate";
  return text.str();
}

bool Retrieval::stopped() { return stop_requested_ && finish(false, "stopped by the user"); }

void Retrieval::enter(Phase phase) {
  progress_.phase = phase;
  if (on_progress_) on_progress_(progress_);
}

bool Retrieval::findPlan(Plan* plan) {
  std::string reason;
  for (int failed = 0; failed < parameters_.max_failed_plans; ++failed) {
    enter(Phase::kPlanning);
    if (stopped()) return false;
    const auto begin = SteadyClock::now();
    planner_->avoid(refused_at_);
    Result<Plan> result = planner_->plan(robot_->pose(), parameters_.goal);
    if (!result) {
      reason = result.reason();
      if (planner_->outage().empty()) {
        result = planner_->planRelaxed(robot_->pose(), parameters_.goal);
      }
    }
    outcome_.planning_s += secondsSince(begin);
    if (planner_->outage().empty()) ++progress_.plans;
    if (result) {
      *plan = std::move(*result);
      planned_risk_ = plan->risk;
      plan->risk = calibration_.corrected(plan->risk);
      progress_.risk = plan->risk;
      outcome_.path = plan->path;
      return true;
    }
    if (!planner_->outage().empty()) continue;  // that is no reason to move
    // Being at the start again is an observation too: what it shows to be free may open a path.
    enter(Phase::kResetting);
    if (stopped()) return false;
    const MotionResult reset = robot_->reset(parameters_.start);
    refused_at_.clear();
    if (reset.end != MotionEnd::kReached) {
      finish(false, "could not reset to the start: " + reset.reason);
      return false;
    }
  }
  finish(false, "no plan in " + std::to_string(parameters_.max_failed_plans) +
                    " attempts; the last said: " + reason);
  return false;
}

MotionResult Retrieval::follow(const Plan& plan) {
  if (motions_ != nullptr) motions_->motionBegins(plan.path, plan.risk);
  MotionResult motion = robot_->follow(plan.path);
  if (motions_ != nullptr) motions_->motionEnded(motion, robot_->pose());
  return motion;
}

bool Retrieval::execute(const Plan& plan) {
  enter(Phase::kMoving);
  if (stopped()) return true;
  const MotionResult motion = follow(plan);
  outcome_.path_length = motion.length;
  noteRefusal(motion);
  const bool ended = motion.end == MotionEnd::kReached || motion.end == MotionEnd::kContact;
  if (ended && motion.set_out) {
    const bool touched = motion.end == MotionEnd::kContact;
    outcome_.motions.push_back({plan.risk, touched});
    calibration_.learn(planned_risk_, touched);
  }
  switch (motion.end) {
    case MotionEnd::kReached:
      if (atGoal()) return finish(true, "the object is at the goal");
      return ++missed_ >= parameters_.max_failed_plans && finish(false, missedGoal());
    case MotionEnd::kContact:
      missed_ = 0;
      ++progress_.collisions;
      if (recover()) return true;
      return progress_.collisions >= parameters_.max_collisions &&
             finish(false, "reached the limit of " + std::to_string(parameters_.max_collisions) +
                               " collisions");
    case MotionEnd::kUnreachable:  // nothing moved: another plan may be within the robot's reach
      return refused_ >= parameters_.max_failed_plans && finish(false, motion.reason);
    case MotionEnd::kFault:
    case MotionEnd::kStopped:
      return finish(false, motion.reason);
  }
  return finish(false, "unknown end of a motion");
}

void Retrieval::noteRefusal(const MotionResult& motion) {
  if (motion.end != MotionEnd::kUnreachable) {
    refused_ = 0;
    refused_at_.clear();
    return;
  }
  ++refused_;
  if (motion.refused_at) refused_at_.push_back(*motion.refused_at);
}

bool Retrieval::recover() {
  // Touching twice at one place means that backing off does not lead away from it.
  const Pose contact_pose = robot_->pose();
  const double moved = gapBetween(contact_pose, last_contact_pose_);
  const bool repeated = progress_.collisions > 1 && moved < parameters_.retreat_distance;
  last_contact_pose_ = contact_pose;
  const bool reset = parameters_.on_contact == OnContact::kReset || repeated;
  enter(reset ? Phase::kResetting : Phase::kRetreating);
  if (stopped()) return true;
  const MotionResult motion =
      reset ? robot_->reset(parameters_.start) : robot_->retreat(parameters_.retreat_distance);
  return motion.end != MotionEnd::kReached &&
         finish(false, "could not back off after the contact: " + motion.reason);
}

bool Retrieval::finish(bool success, const std::string& reason) {
  outcome_.success = success;
  outcome_.reason = reason;
  return true;
}

}  // namespace smore
