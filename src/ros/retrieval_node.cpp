// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/client/simple_action_client.h>
#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <cstdint>
#include <mutex>

#include "retrieval_node_parameters.h"
#include "smore/retrieval/reconstruction.h"
#include "smore/retrieval/retrieval.h"
#include "smore/ros/arm_description.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/payload_tilts.h"
#include "smore/ros/remote_planner.h"
#include "smore/ros/retrieval_summary.h"
#include "smore/ros/settled_maps.h"
#include "smore/ros/shutdown_request.h"

namespace smore {
namespace {

constexpr double kLookPeriod = 0.01;  // between two looks whether the node is to end [s]
constexpr double kLastWords = 0.5;    // that a retrieval has to end when the node ends [s]
constexpr double kComesToRest = 0.2;  // an arm that was stopped [s]
constexpr char kStillPresses[] =
    "; the object may still press where it is, and the next goal begins by backing off";

/// Offers the retrieval loop as an action. The loop runs in the action's thread.
class RetrievalNode {
 public:
  RetrievalNode(const RetrievalNodeParameters& parameters, const Scenario& scenario)
      : parameters_(parameters),
        scenario_(scenario),
        robot_(parameters.robot, describedCommands(scenario, parameters.robot_description)),
        planner_(parameters.frames.world, &robot_),
        server_(
            node_, names::kRetrieve, [this](const auto& goal) { execute(*goal); }, false) {
    stop_ = node_.advertiseService(names::kStop, &RetrievalNode::onStop, this);
    server_.registerPreemptCallback([this] { robot_.requestStop(); });
    server_.start();
  }

  /// Takes goals until the node is to end.
  void run() {
    while (!shutdown_.pending()) look();
    endAtRest();
  }

  /// One retrieval to the scenario's goal; whether it succeeded, or was ended from outside.
  bool runOnce() {
    // The client, in a thread of its own, waits for a clock that may never come, deaf meanwhile.
    while (!ros::Time::isValid()) {
      if (shutdown_.pending()) return true;
      ros::WallDuration(kLookPeriod).sleep();
    }
    actionlib::SimpleActionClient<smore_msgs::RetrieveAction> client(node_, names::kRetrieve, true);
    while (!client.isServerConnected()) {
      if (shutdown_.pending()) return true;
      ros::WallDuration(kLookPeriod).sleep();
    }
    client.sendGoal(smore_msgs::RetrieveGoal());
    while (!client.getState().isDone()) {
      if (shutdown_.pending()) {
        endAtRest();
        return true;
      }
      look();
    }
    return client.getResult()->success != 0;
  }

 private:
  using Server = actionlib::SimpleActionServer<smore_msgs::RetrieveAction>;

  /// Waits for a moment. A goal that comes while the robot backs off goes first: it backs off
  /// itself, and its cancel is heard.
  void look() {
    ros::WallDuration(kLookPeriod).sleep();
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    if (backs_off_ && server_.isNewGoalAvailable()) robot_.requestStop();
  }

  /// Ends the goal that is active, and one that has come but not begun.
  bool onStop(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    if (server_.isNewGoalAvailable()) stop_next_ = true;
    stopped_ = true;
    if (stop_next_ || server_.isActive() || backs_off_) {
      robot_.requestStop();
    } else {
      robot_.halt();
    }
    response.success = static_cast<unsigned char>(true);
    response.message = "the robot was told to stop";
    return true;
  }

  /// The stop goes out before ROS ends, and the retrieval has a moment to say how it ended.
  void endAtRest() {
    {
      const std::lock_guard<std::mutex> lock(stop_mutex_);
      stopped_ = true;
      robot_.requestStop();
    }
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kLastWords);
    while (server_.isActive() && ros::ok() && ros::WallTime::now() < deadline) {
      ros::WallDuration(kLookPeriod).sleep();
    }
  }

  /// A wish to stop that came before the goal began counts as one that comes later.
  void takeEarlyStop() {
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    if (stop_next_ || server_.isPreemptRequested() || shutdown_.pending()) robot_.requestStop();
    stopped_ = stop_next_;
    stop_next_ = false;
  }

  void execute(const smore_msgs::RetrieveGoal& goal) {
    takeEarlyStop();
    robot_.forgetFaults();
    const ros::WallTime begin = ros::WallTime::now();
    RetrievalSummary summary;
    RetrievalOutcome& outcome = summary.outcome = attempt(goal);
    summary.scenario = scenario_.name;
    summary.method = methodName(parameters_.method);
    summary.wall_s = (ros::WallTime::now() - begin).toSec();
    summary.cancelled = !outcome.success && robot_.stopRequested();
    robot_.endGoal(outcome.success);
    const bool backs_off = summary.cancelled && mayBackOff();
    if (!outcome.success && !backs_off && robot_.canBackOff()) outcome.reason += kStillPresses;
    // Who cancels waits for the answer, not for the way back or the maps.
    if (summary.cancelled) finish(outcome);
    if (backs_off) endFree();
    report(summary);
    if (!summary.cancelled) finish(outcome);
    robot_.clearStop();
  }

  /// Whether the goal ended by a cancel, after which the robot may move; after a stop and a fault
  /// nothing does.
  bool mayBackOff() {
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    backs_off_ = server_.isPreemptRequested() && !stopped_ && !robot_.faulted();
    if (backs_off_) robot_.clearStop();
    return backs_off_;
  }

  /// Backs off if something presses; what touched last may be felt only now.
  void endFree() {
    const std::string problem = robot_.standStill(kComesToRest) ? backOff() : "";
    if (!problem.empty()) ROS_WARN_STREAM(problem);
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    backs_off_ = false;
  }

  RetrievalOutcome attempt(const smore_msgs::RetrieveGoal& goal) {
    RetrievalParameters parameters = retrievalParameters(scenario_);
    parameters.max_collisions =
        goal.max_collisions > 0 ? countOf(goal.max_collisions) : parameters_.max_collisions;
    parameters.retreat_distance = parameters_.retreat_distance;
    RetrievalOutcome outcome;
    if (!goal.goal.header.frame_id.empty()) {
      const Result<Pose> pose = fromMessage(goal.goal, parameters_.frames.world);
      if (!pose) outcome.reason = "goal: " + pose.reason();
      if (!pose) return outcome;
      parameters.goal = *pose;
    }
    outcome.reason = beforeMotion(parameters);
    if (robot_.stopRequested()) outcome.reason = "stopped by the user";
    if (!outcome.reason.empty()) return outcome;
    return scenario_.task == Task::kReconstruct ? touch(goal.max_collisions) : retrieve(parameters);
  }

  /// What hinders a retrieval to begin; empty where nothing does. The weight is found by motions
  /// that an object at its goal is spared.
  std::string beforeMotion(const RetrievalParameters& parameters) {
    const bool retrieves = scenario_.task == Task::kRetrieve;
    const std::string outside = scenario_.motionSpace().whyOutside(parameters.goal);
    if (retrieves && !outside.empty()) return "the goal " + outside;
    if (std::string problem = waitUntilReady(); !problem.empty()) return problem;
    const std::string beside = scenario_.motionSpace().whyBeside(robot_.pose());
    if (!beside.empty()) return "the object is " + beside + "; bring it there first";
    return retrieves && isAtGoal(parameters, robot_.pose()) ? "" : identifyPayload();
  }

  std::string waitUntilReady() {
    std::string problem = backOff();
    if (!problem.empty()) return problem;
    ROS_INFO("waiting for sensor, maps and planner");
    problem = robot_.waitUntilReady();
    if (!problem.empty()) return problem;
    return planner_.waitUntilReady(parameters_.robot.ready_timeout)
               ? ""
               : "the planner's service does not appear; is the planner node up?";
  }

  /// Where a stop left the object pressed: what presses would become the sensor's zero. Why it
  /// still presses; empty where it does not, or where somebody else has moved it.
  std::string backOff() {
    if (!robot_.canBackOff()) return "";
    ROS_INFO("backing off from where the last retrieval was stopped");
    const MotionResult away = robot_.retreat(parameters_.retreat_distance);
    if (away.end == MotionEnd::kReached) return "";
    return "could not back off from where the last retrieval was stopped: " + away.reason;
  }

  std::string identifyPayload() {
    if (!parameters_.identify_payload || !tiltsPayload(scenario_)) return "";
    ROS_INFO("tilting the object to find its weight");
    return identifyPayloadByTilting(&robot_, &node_, parameters_.payload_tilt);
  }

  RetrievalOutcome retrieve(const RetrievalParameters& parameters) {
    Retrieval retrieval(parameters, &robot_, &planner_, [this, &retrieval](const auto& progress) {
      show(progress);
      if (robot_.stopRequested()) retrieval.requestStop();
    });
    return retrieval.run();
  }

  /// `max_collisions`: of the goal; 0: those that the scenario asks for.
  RetrievalOutcome touch(std::uint32_t max_collisions) {
    RemoteTouchPlanner touches(parameters_.frames.world, &robot_);
    ReconstructionParameters parameters = reconstructionParameters(scenario_);
    parameters.retreat_distance = parameters_.retreat_distance;
    if (max_collisions > 0) parameters.max_collisions = countOf(max_collisions);
    return reconstruct(
        parameters, &robot_, &touches, [this](const auto& progress) { show(progress); },
        [this] { return robot_.stopRequested(); });
  }

  void show(const RetrievalProgress& progress) {
    ROS_INFO("%s: %d contacts, %d plans, risk %.2f", phaseName(progress.phase), progress.collisions,
             progress.plans, progress.risk);
    server_.publishFeedback(toMessage(progress));
  }

  void report(const RetrievalSummary& summary) {
    ROS_INFO_STREAM("\n" << toText(summary));
    if (parameters_.output.empty()) return;
    const std::string problem = saveSettledMaps(&node_, robot_.stamp(), parameters_.output);
    if (!problem.empty()) ROS_ERROR_STREAM("maps not saved: " << problem);
    const std::string file = parameters_.output + "/summary.json";
    if (!writeJson(summary, file)) ROS_ERROR_STREAM(file << ": cannot be written");
  }

  void finish(const RetrievalOutcome& outcome) {
    const smore_msgs::RetrieveResult result = toMessage(outcome);
    if (outcome.success) {
      server_.setSucceeded(result, outcome.reason);
    } else if (server_.isPreemptRequested()) {
      server_.setPreempted(result, outcome.reason);
    } else {
      server_.setAborted(result, outcome.reason);
    }
  }

  RetrievalNodeParameters parameters_;
  Scenario scenario_;
  ros::NodeHandle node_;
  RosRobot robot_;
  RemotePlanner planner_;
  ros::ServiceServer stop_;
  std::mutex stop_mutex_;
  bool stop_next_ = false;  ///< guarded by stop_mutex_: the goal that has not begun is to end
  bool stopped_ = false;  ///< guarded by stop_mutex_: somebody asked for the stop of the last goal
  bool backs_off_ = false;  ///< guarded by stop_mutex_: after a cancel
  ShutdownRequest shutdown_;
  Server server_;
};

void runRetrieval() {
  ParameterReader reader(privateParameters(), ros::this_node::getName());
  RetrievalNodeParameters parameters = readRetrievalParameters(&reader);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  requireScenario(&reader);
  reader.finish();
  // An arm cannot be set to the start: it goes back along its way.
  if (isArm(scenario->robot)) parameters.robot.reset_service.clear();

  ros::AsyncSpinner spinner(1);
  spinner.start();
  RetrievalNode node(parameters, *scenario);
  if (!parameters.auto_start) {
    node.run();
  } else if (!node.runOnce()) {
    throw std::runtime_error("the retrieval did not succeed");
  }
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) {
  return smore::runNode(argc, argv, "retrieval", smore::runRetrieval);
}
