// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/server.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <boost/thread/recursive_mutex.hpp>
#include <mutex>

namespace smore {

/// Parameters of a node that others may change while it runs, by dynamic_reconfigure. `Config` is
/// the class that is generated of a file in cfg/; all its parameters are numbers.
///
/// They have a thread of their own, since a change waits for the master, which keeps it: a node
/// that is started again within one launch goes on with it.
template <typename Config>
class DynamicParameters {
 public:
  /// Starts with `now`. What is wished outside of `least` to `most` is refused with a warning, and
  /// what was in force stays.
  DynamicParameters(const Config& now, const Config& least, const Config& most)
      : now_(now), least_(least), most_(most), node_(makeNode()), server_(mutex_, node_) {
    server_.setConfigDefault(now);
    server_.setConfigMin(least);
    server_.setConfigMax(most);
    server_.setCallback([this](Config& wish, std::uint32_t /*level*/) { decide(&wish); });
    thread_.start();
  }

  /// What is in force; from any thread, without waiting.
  Config now() const {
    const std::lock_guard<std::mutex> lock(now_mutex_);
    return now_;
  }

  /// What somebody wishes by other ways than dynamic_reconfigure; in a callback of `queue`.
  void wish(Config wish) {
    decide(&wish);
    server_.updateConfig(wish);
  }

  /// Served by the same thread.
  ros::CallbackQueue* queue() { return &queue_; }

 private:
  using Number = typename Config::template ParamDescription<double>;

  ros::NodeHandle makeNode() {
    ros::NodeHandle node("~");
    node.setCallbackQueue(&queue_);
    now_.__toServer__(node);  // which is what the server begins with
    return node;
  }

  void decide(Config* wish) {
    const Config before = now();
    for (const auto& parameter : Config::__getParamDescriptions__()) {
      const auto number = boost::dynamic_pointer_cast<const Number>(parameter);
      const double wished = (*wish).*(number->field);
      const double least = least_.*(number->field);
      const double most = most_.*(number->field);
      if (wished >= least && wished <= most) continue;
      (*wish).*(number->field) = before.*(number->field);
      ROS_WARN_STREAM("'" << node_.resolveName(number->name) << "' stays "
                          << before.*(number->field) << ": " << wished << " is not within " << least
                          << " to " << most << ", what may be set while the node runs");
    }
    const std::lock_guard<std::mutex> lock(now_mutex_);
    now_ = *wish;
  }

  mutable std::mutex now_mutex_;
  Config now_;
  Config least_, most_;
  boost::recursive_mutex mutex_;  ///< of the server: held while it waits for the master
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  dynamic_reconfigure::Server<Config> server_;
  ros::AsyncSpinner thread_{1, &queue_};  ///< last: ends before what its callbacks use
};

}  // namespace smore
