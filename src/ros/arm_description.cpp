// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/arm_description.h"

#include <ros/ros.h>

#include "smore/kinematics/described_arm.h"

namespace smore {
namespace {

// A driver that is started at the same time sets its parameter meanwhile [s of wall time].
constexpr double kPatience = 5.0;
constexpr double kLookPeriod = 0.1;  // [s]

bool waitForText(const std::string& name, std::string* text) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!ros::param::get(name, *text)) {
    if (!ros::ok() || ros::WallTime::now() > deadline) return false;
    ros::WallDuration(kLookPeriod).sleep();
  }
  return true;
}

}  // namespace

std::string readDescriptionName(ParameterReader* reader) {
  std::string name;
  if (reader->has("robot_description")) reader->text("robot_description", &name);
  return name;
}

UrdfModel armByDescription(const Scenario& scenario, const std::string& name) {
  if (name.empty()) return armUrdf(scenario);
  std::string xml;
  if (!waitForText(name, &xml)) {
    ROS_WARN_STREAM("no parameter '" << name << "': the arm is the maker's nominal "
                                     << robotText(scenario)
                                     << ", from which a real one differs by millimetres; is the "
                                        "driver up?");
    return armUrdf(scenario);
  }
  return describedArm(scenario, parseUrdf(xml, "the parameter " + name));
}

std::unique_ptr<JointCommands> describedCommands(const Scenario& scenario,
                                                 const std::string& name) {
  if (!isArm(scenario.robot)) return makeJointCommands(scenario);
  return makeJointCommands(scenario, armByDescription(scenario, name));
}

}  // namespace smore
