// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

#include "smore/planning/planner.h"
#include "smore/retrieval/touch_planner.h"
#include "smore/ros/ros_robot.h"

namespace smore {

/// The planner node, asked for paths on maps that hold everything that the robot has felt. A call
/// fails at once when the robot is told to stop.
class RemotePlanner : public Planner {
 public:
  /// Poses are those of the object in `world_frame`. The robot must outlive this.
  RemotePlanner(const std::string& world_frame, const RosRobot* robot);

  /// Whether the node offers its service within `timeout` [s of wall time].
  bool waitUntilReady(double timeout);

  Result<Plan> plan(const Pose& start, const Pose& goal) override;
  std::string outage() const override { return outage_; }
  Result<Plan> planRelaxed(const Pose& start, const Pose& goal) override;

 private:
  Result<Plan> ask(const Pose& start, const Pose& goal, bool relaxed);

  std::string world_frame_;
  std::string outage_;
  const RosRobot* robot_;
  ros::NodeHandle node_;
  ros::ServiceClient client_;
};

/// The planner node, asked for touches on maps that hold everything that the robot has felt. A call
/// fails at once when the robot is told to stop.
class RemoteTouchPlanner : public TouchPlanner {
 public:
  /// As for RemotePlanner.
  RemoteTouchPlanner(const std::string& world_frame, const RosRobot* robot);

  Result<Path> nextTouch(const Pose& from) override;

 private:
  std::string world_frame_;
  const RosRobot* robot_;
  ros::NodeHandle node_;
  ros::ServiceClient client_;
};

}  // namespace smore
