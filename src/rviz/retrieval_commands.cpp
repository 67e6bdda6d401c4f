// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval_commands.h"

#include <ros/topic.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Trigger.h>

#include <iomanip>
#include <sstream>

#include "smore/ros/conversions.h"
#include "smore/ros/interruptible_call.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

constexpr double kStopPatience = 0.5;  // that the retrieval has to answer [s of wall time]
constexpr double kPosePatience = 2.0;  // to hear where the object is [s of ROS time]

/// Calls it and gives its message, which says success and failure alike.
template <typename Service>
std::string ask(ros::ServiceClient client, Service call) {
  if (!client.call(call)) {
    return "the service '" + client.getService() + "' does not answer; is its node up?";
  }
  return call.response.message;
}

std::string stopBy(const ros::ServiceClient& retrieval, const ros::ServiceClient& guard) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kStopPatience);
  std_srvs::Trigger call;
  const auto too_late = [deadline] { return ros::WallTime::now() > deadline; };
  if (callInterruptibly(retrieval, &call, too_late)) return call.response.message;
  if (ros::ServiceClient(guard).call(call)) return "the retrieval does not answer: by the guard";
  return "nobody answers: use the robot's own stop";
}

std::string planTo(const Pose& goal, ros::NodeHandle node, ros::ServiceClient planner) {
  const auto here = ros::topic::waitForMessage<smore_msgs::ContactObservation>(
      names::kContact, node, ros::Duration(kPosePatience));
  if (!here) return "no contact observation says where the object is; is the listener running?";
  smore_msgs::PlanPath call;
  call.request.start.header.frame_id = here->world_frame;
  call.request.start.pose = here->pose;
  call.request.goal.header.frame_id = here->world_frame;
  call.request.goal.pose = toMessage(goal);
  if (!planner.call(call)) return "the planner does not answer; is its node up?";
  if (call.response.success == 0) return call.response.message;
  std::ostringstream said;
  said << std::fixed << std::setprecision(2) << "touches with probability " << call.response.risk;
  return said.str();
}

}  // namespace

RetrievalCommands::RetrievalCommands(const ros::NodeHandle& node) : node_(node) {
  goals_ = node_.advertise<smore_msgs::RetrieveActionGoal>(std::string(names::kRetrieve) + "/goal",
                                                           names::kLatestQueue);
  constexpr bool kLatched = true;
  shown_ =
      node_.advertise<std_msgs::Float64>(names::kShownProbability, names::kLatestQueue, kLatched);
}

void RetrievalCommands::retrieve() {
  runner_.start(kRetrieve, [goals = goals_] {
    if (goals.getNumSubscribers() == 0) return "nobody takes goals; is the retrieval node up?";
    goals.publish(smore_msgs::RetrieveActionGoal());
    return "begun";
  });
}

void RetrievalCommands::plan(const std::optional<Pose>& goal) {
  const auto planner = node_.serviceClient<smore_msgs::PlanPath>(names::kPlanPath);
  runner_.start(kPlan, [goal, node = node_, planner]() -> std::string {
    if (!goal) return "nobody says what the goal is; is the mapping node up?";
    return planTo(*goal, node, planner);
  });
}

void RetrievalCommands::stop() {
  const auto retrieval = node_.serviceClient<std_srvs::Trigger>(names::kStop);
  const auto guard = node_.serviceClient<std_srvs::Trigger>(names::kGuardStop);
  runner_.start(kStop, [retrieval, guard] { return stopBy(retrieval, guard); });
}

void RetrievalCommands::clearFault() { trigger(kClear, names::kGuardClear); }
void RetrievalCommands::tare() { trigger(kTare, names::kListenerTare); }
void RetrievalCommands::identifyPayload() { trigger(kIdentify, names::kListenerIdentifyPayload); }
void RetrievalCommands::resetMaps() { trigger(kReset, names::kResetMaps); }

void RetrievalCommands::saveBelief(const std::string& name, bool overwrite) {
  const auto client = node_.serviceClient<smore_msgs::SaveBelief>(names::kSaveBelief);
  smore_msgs::SaveBelief call;
  call.request.file = name;
  call.request.overwrite = static_cast<unsigned char>(overwrite);
  runner_.start(kSave, [client, call] { return ask(client, call); });
}

void RetrievalCommands::loadBelief(const std::string& name) {
  const auto client = node_.serviceClient<smore_msgs::LoadBelief>(names::kLoadBelief);
  smore_msgs::LoadBelief call;
  call.request.file = name;
  runner_.start(kLoad, [client, call] { return ask(client, call); });
}

void RetrievalCommands::showFrom(double probability) {
  std_msgs::Float64 message;
  message.data = probability;
  shown_.publish(message);
}

void RetrievalCommands::trigger(const char* command, const char* service) {
  const auto client = node_.serviceClient<std_srvs::Trigger>(service);
  runner_.start(command, [client] { return ask(client, std_srvs::Trigger()); });
}

}  // namespace smore
