// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <visualization_msgs/MarkerArray.h>

#include <memory>
#include <string>
#include <vector>

#include "smore/ros/conversions.h"
#include "smore/scenario/scenario.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

/// What the driver of the real robot broadcasts beside wrench and joint states.
class SimulatedDriver {
 public:
  using Transforms = std::vector<geometry_msgs::TransformStamped>;

  virtual ~SimulatedDriver() = default;

  /// The frame that wrenches are given in.
  virtual std::string sensorFrame() const = 0;

  /// Transforms that never change.
  virtual Transforms fixedTransforms() const = 0;

  /// Those of them that a real controller gives: where its base is in the robot's description.
  virtual Transforms controllerTransforms() const = 0;

  /// What goes with a sample: what gives the object's pose at each, and 25 times a second the
  /// frames of the robot's links, for display.
  Transforms transformsAt(const SimulatedRobot& robot, const ros::Time& stamp);

  /// For display: the scene and the robot's links, in their frames.
  visualization_msgs::MarkerArray markersIn(const Scenario& scenario,
                                            const FrameNames& frames) const;

 private:
  virtual visualization_msgs::MarkerArray linkMarkers() const = 0;
  virtual Transforms poseTransforms(const SimulatedRobot& robot, const ros::Time& stamp) const = 0;
  virtual Transforms linkTransforms(const SimulatedRobot& robot, const ros::Time& stamp) const = 0;

  ros::Time last_links_;
};

std::unique_ptr<SimulatedDriver> makeSimulatedDriver(const Scenario& scenario,
                                                     const FrameNames& frames);

/// The driver of an arm with this description, on whose pendant a tool centre point is set [m, in
/// the flange's frame]: the driver gives its pose for the sensor's.
std::unique_ptr<SimulatedDriver> makeArmDriver(const Scenario& scenario, const FrameNames& frames,
                                               const UrdfModel& arm, const Vec3& tcp);

}  // namespace smore
