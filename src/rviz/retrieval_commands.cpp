// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval_commands.h"

#include <std_msgs/Float64.h>
#include <std_msgs/Int32.h>
#include <std_srvs/Trigger.h>

#include <iomanip>
#include <sstream>

#include "smore/ros/interruptible_call.h"
#include "smore/ros/messages.h"
#include "smore/ros/names.h"
#include "smore/ros/plan_from_here.h"

namespace smore {
namespace {

constexpr double kStopPatience = 0.5;  // that the retrieval has to answer [s of wall time]

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

}  // namespace

RetrievalCommands::RetrievalCommands(const ros::NodeHandle& node) : node_(node) {
  goals_ = node_.advertise<smore_msgs::RetrieveActionGoal>(std::string(names::kRetrieve) + "/goal",
                                                           names::kLatestQueue);
  constexpr bool kLatched = true;
  shown_ =
      node_.advertise<std_msgs::Float64>(names::kShownProbability, names::kLatestQueue, kLatched);
  world_ = node_.advertise<std_msgs::Int32>(names::kShownWorld, names::kLatestQueue, kLatched);
}

void RetrievalCommands::begin(const char* command, const Goal& goal) {
  smore_msgs::RetrieveActionGoal message;
  if (goal) message.goal.goal = *goal;
  runner_.start(command, [message, goals = goals_] {
    if (goals.getNumSubscribers() == 0) return "nobody takes goals; is the retrieval node up?";
    goals.publish(message);
    return "begun";
  });
}

void RetrievalCommands::plan(const Goal& goal) {
  runner_.start(kPlan, [goal, node = node_]() -> std::string {
    if (!goal) return "no goal is marked: is the planner node up, and the task a retrieval?";
    const Result<double> risk = planFromHere(node, *goal);
    if (!risk) return risk.reason();
    std::ostringstream said;
    said << std::fixed << std::setprecision(2) << "touches with probability " << *risk;
    return said.str();
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

void RetrievalCommands::showWorld(int number) {
  std_msgs::Int32 message;
  message.data = number;
  world_.publish(message);
}

void RetrievalCommands::trigger(const char* command, const char* service) {
  const auto client = node_.serviceClient<std_srvs::Trigger>(service);
  runner_.start(command, [client] { return ask(client, std_srvs::Trigger()); });
}

}  // namespace smore
