// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smore {

/// Lets a node do a last thing, such as stopping its robot, before ROS shuts down: while one of
/// these lives, SIGINT, SIGTERM and the shutdown that `rosnode kill` asks for only note the wish.
/// The node must look for it often, and end.
///
/// One in a program at a time, made after ros::start.
class ShutdownRequest {
 public:
  ShutdownRequest();
  ~ShutdownRequest();
  ShutdownRequest(const ShutdownRequest&) = delete;
  ShutdownRequest& operator=(const ShutdownRequest&) = delete;

  /// Whether the node is to end; from any thread.
  bool pending() const;
};

}  // namespace smore
