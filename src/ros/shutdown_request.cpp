// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/shutdown_request.h"

#include <XmlRpcValue.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>

namespace smore {
namespace {

constexpr char kShutdown[] = "shutdown";  // of the API that each ROS node has for others

// A signal handler reaches nothing but what lives as long as the program.
std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait for a lock");

void onSignal(int /*signal*/) { requested = true; }

void onRemoteRequest(XmlRpc::XmlRpcValue& /*request*/, XmlRpc::XmlRpcValue& response) {
  requested = true;
  constexpr int kSuccess = 1;
  response = ros::xmlrpc::responseInt(kSuccess, "", 0);
}

}  // namespace

ShutdownRequest::ShutdownRequest() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  ros::XMLRPCManager::instance()->unbind(kShutdown);
  ros::XMLRPCManager::instance()->bind(kShutdown, onRemoteRequest);
}

// The node ends now: further signals have their usual effect.
ShutdownRequest::~ShutdownRequest() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool ShutdownRequest::pending() const { return requested || !ros::ok(); }

}  // namespace smore
