// SPDX-License-Identifier: BSD-3-Clause
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <limits>
#include <memory>

#include "smore/ros/evidence_messages.h"
#include "smore/ros/goal_marker.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/plan_display.h"
#include "smore/ros/planner_status.h"

namespace smore {
namespace {

// Between the poses at which the drawn path changes its colour.
constexpr double kColorDistance = 0.02;  // [m]
constexpr double kColorAngle = 0.1;      // [rad]

constexpr double kStatusPeriod = 0.1;  // between two looks whether statuses are due [s]

struct PlannerNodeParameters {
  FrameNames frames;
  MethodKind method = MethodKind::kSmore;
  int seed = 1;
  double maps_timeout = 30.0;          ///< wall time to wait for maps that are new enough [s]
  MethodParameters method_parameters;  ///< of the method
};

PlannerNodeParameters readParameters(ParameterReader* reader) {
  PlannerNodeParameters parameters;
  parameters.frames = readFrameNames(reader);
  parameters.method = readMethod(reader);
  reader->integer("seed", &parameters.seed, 0, std::numeric_limits<int>::max());
  reader->number("maps_timeout", &parameters.maps_timeout, {0.1, 60.0});
  MethodParameters defaults;
  reader->number("time_limit", &defaults.planner.time_limit, {0.01, 3600.0});
  parameters.method_parameters = readMethodChanges(reader, parameters.method, defaults);
  return parameters;
}

/// Plans on a replica of the mapping's belief that is brought up to date before each plan. One call
/// at a time.
class PlannerNode {
 public:
  PlannerNode(const PlannerNodeParameters& parameters, const Scenario& scenario)
      : parameters_(parameters),
        replica_(parameters.method, scenario, parameters.seed, parameters.method_parameters),
        knowledge_(replica_.knowledge()),
        display_(node_, scenario.voxel_size, parameters.frames.world) {
    maps_ = node_.serviceClient<smore_msgs::TwinMaps>(names::kTwinMaps);
    path_ = node_.advertise<nav_msgs::Path>(names::kPath, names::kLatestQueue, true);
    plan_ = node_.advertiseService(names::kPlanPath, &PlannerNode::onPlan, this);
    touch_ = node_.advertiseService(names::kPlanTouch, &PlannerNode::onTouch, this);
    check_ = node_.advertiseService(names::kCheckPose, &PlannerNode::onCheck, this);
    source_ =
        node_.subscribe(names::kEvidenceSource, names::kLatestQueue, &PlannerNode::onSource, this);
    if (scenario.task == Task::kRetrieve) {
      marker_ = std::make_unique<GoalMarker>(scenario, parameters.frames, knowledge_);
    }
    statuses_.add("plans", [this](Status* status) { status_.compose(status); });
    timer_ = status_node_.createWallTimer(ros::WallDuration(kStatusPeriod),
                                          &PlannerNode::onStatusTimer, this);
  }

  /// Serves until ROS ends; how it fares is told beside, while a plan is being made too.
  void run() {
    ros::AsyncSpinner statuses(1, &status_queue_);
    statuses.start();
    ros::spin();
  }

 private:
  /// Brings the replica up to date; the reason where that fails, else empty.
  std::string synchronise(const ros::Time& not_before) {
    try {
      std::string problem = takeEvidence(not_before);
      if (problem.empty()) knowledge_ = replica_.knowledge();
      if (problem.empty() && marker_) marker_->know(knowledge_);
      return problem;
    } catch (const InputError& error) {  // knowledge that the planner's method cannot use
      return error.what();
    }
  }

  std::string takeEvidence(const ros::Time& not_before) {
    constexpr int kAttempts = 2;  // the second one with all evidence
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      smore_msgs::TwinMaps call;
      call.request.not_before = not_before;
      call.request.timeout = ros::Duration(parameters_.maps_timeout);
      call.request.with_evidence = static_cast<unsigned char>(true);
      call.request.epoch = replica_.epoch();
      call.request.evidence_from = replica_.size();
      if (!maps_.call(call)) {
        return "the service '" + maps_.getService() + "' does not answer; is the mapping node up?";
      }
      if (!call.response.success) return call.response.message;
      const Result<EvidencePart> part = fromMessage(call.response.evidence);
      if (!part) return part.reason();
      revision_ = call.response.revision;
      stamp_ = call.response.stamp;
      if (replica_.extend(*part)) return "";
    }
    return "the planner's maps differ from the mapping's; give both nodes the same scenario, "
           "method, parameters and seed";
  }

  bool onPlan(smore_msgs::PlanPath::Request& request, smore_msgs::PlanPath::Response& response) {
    status_.begin();
    response.message = plan(request, &response);
    response.success = static_cast<unsigned char>(response.message.empty());
    if (response.success == 0) status_.refuse(response.message);
    return true;
  }

  std::string plan(const smore_msgs::PlanPath::Request& request,
                   smore_msgs::PlanPath::Response* response) {
    const Result<Pose> start = fromMessage(request.start, parameters_.frames.world);
    if (!start) return "start: " + start.reason();
    const Result<Pose> goal = fromMessage(request.goal, parameters_.frames.world);
    if (!goal) return "goal: " + goal.reason();
    std::vector<Pose> refused;
    for (const geometry_msgs::Pose& message : request.refused) {
      const Result<Pose> pose = fromMessage(message);
      if (!pose) return "refused: " + pose.reason();
      refused.push_back(*pose);
    }
    std::string problem = synchronise(request.not_before);
    if (!problem.empty()) return problem;

    response->searched = static_cast<unsigned char>(true);
    const ros::WallTime begin = ros::WallTime::now();
    const Result<Plan> plan =
        replica_.plan(*start, *goal, request.relaxed != 0, std::move(refused));
    if (!plan) return plan.reason();
    ROS_INFO("path of %.2f m at risk %.2f planned in %.2f s", pathLength(plan->path), plan->risk,
             (ros::WallTime::now() - begin).toSec());
    response->path = toMessage(plan->path, parameters_.frames.world, stamp_.toSec());
    response->risk = plan->risk;
    response->revision = revision_;
    status_.find(pathLength(plan->path), plan->risk);
    path_.publish(response->path);
    const Path dense = densify(plan->path, kColorDistance, kColorAngle);
    display_.show({dense, replica_.risksAlong(dense), knowledge_.object, plan->tree});
    return "";
  }

  bool onTouch(smore_msgs::PlanTouch::Request& request, smore_msgs::PlanTouch::Response& response) {
    status_.begin();
    const Result<Path> path = touch(request);
    if (path) {
      status_.find(pathLength(*path), std::nullopt);
    } else {
      status_.refuse(path.reason());
    }
    response.enough = static_cast<unsigned char>(path && path->empty());
    response.success = static_cast<unsigned char>(path && !path->empty());
    if (!path) response.message = path.reason();
    if (response.enough != 0) response.message = "no motion would tell enough";
    if (response.success == 0) return true;
    response.path = toMessage(*path, parameters_.frames.world, stamp_.toSec());
    path_.publish(response.path);
    return true;
  }

  Result<Path> touch(const smore_msgs::PlanTouch::Request& request) {
    const Result<Pose> start = fromMessage(request.start, parameters_.frames.world);
    if (!start) return Failure{"start: " + start.reason()};
    const std::string problem = synchronise(request.not_before);
    if (!problem.empty()) return Failure{problem};
    return replica_.nextTouch(*start);
  }

  bool onCheck(smore_msgs::CheckPose::Request& request, smore_msgs::CheckPose::Response& response) {
    const Result<Pose> pose = fromMessage(request.pose, parameters_.frames.world);
    response.message = pose ? synchronise(ros::Time()) : pose.reason();
    response.success = static_cast<unsigned char>(response.message.empty());
    if (!response.message.empty()) return true;
    const PoseAssessment assessment = knowledge_.assess(*pose);
    response.valid = static_cast<unsigned char>(assessment.valid);
    response.risk = assessment.risk;
    response.message = assessment.problem;
    return true;
  }

  /// The mapping begins anew, after a reset or with what it was told: what is shown follows at
  /// once.
  void onSource(const smore_msgs::EvidenceSource& /*message*/) {
    const std::string problem = synchronise(ros::Time());
    if (!problem.empty()) ROS_WARN_STREAM(problem);
  }

  void onStatusTimer(const ros::WallTimerEvent& /*event*/) { statuses_.publishIfDue(); }

  static ros::NodeHandle nodeOn(ros::CallbackQueue* queue) {
    ros::NodeHandle node;
    node.setCallbackQueue(queue);
    return node;
  }

  PlannerNodeParameters parameters_;
  MethodReplica replica_;
  PoseKnowledge knowledge_;  ///< of the replica, as it was when it was last brought up to date
  std::uint64_t revision_ = 0;
  ros::Time stamp_;
  ros::NodeHandle node_;
  ros::ServiceClient maps_;
  ros::Publisher path_;
  PlanDisplay display_;
  ros::ServiceServer plan_, touch_, check_;
  ros::Subscriber source_;
  std::unique_ptr<GoalMarker> marker_;  ///< null where the task has no goal
  PlannerStatus status_;
  StatusPublisher statuses_;
  ros::CallbackQueue status_queue_;
  ros::NodeHandle status_node_ = nodeOn(&status_queue_);
  ros::WallTimer timer_;
};

void runPlanner() {
  ParameterReader reader(privateParameters(), ros::this_node::getName());
  const PlannerNodeParameters parameters = readParameters(&reader);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  requireScenario(&reader);
  reader.finish();
  PlannerNode(parameters, *scenario).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) { return smore::runNode(argc, argv, "planner", smore::runPlanner); }
