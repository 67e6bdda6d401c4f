// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <thread>
#include <utility>

namespace smore {

/// Calls a service, which may take long, until it has answered or `given_up` says so; whether it
/// has answered. An answer that comes later is forgotten.
template <class Service>
bool callInterruptibly(const ros::ServiceClient& client, Service* call,
                       const std::function<bool()>& given_up) {
  constexpr std::chrono::milliseconds kLookPeriod(5);
  auto open = std::make_shared<std::pair<ros::ServiceClient, Service>>(client, *call);
  std::packaged_task<bool()> task([open] { return open->first.call(open->second); });
  std::future<bool> answered = task.get_future();
  std::thread(std::move(task)).detach();
  while (answered.wait_for(kLookPeriod) != std::future_status::ready) {
    if (given_up()) return false;
  }
  *call = open->second;
  return answered.get();
}

/// Whether the service appears within `timeout` [s of wall time] and before `given_up` says so.
inline bool waitForService(ros::ServiceClient* client, double timeout,
                           const std::function<bool()>& given_up) {
  constexpr double kServicePeriod = 0.05;  // between two looks [s]
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  while (!client->exists()) {
    if (given_up() || !ros::ok() || ros::WallTime::now() > deadline) return false;
    ros::WallDuration(kServicePeriod).sleep();
  }
  return true;
}

}  // namespace smore
