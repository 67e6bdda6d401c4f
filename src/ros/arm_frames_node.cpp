// SPDX-License-Identifier: BSD-3-Clause
// Broadcasts where the arm stands and how it holds the object, as the scenario has it.
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include "smore/ros/arm_description.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/robot_frames.h"

namespace smore {
namespace {

void runArmFrames() {
  ParameterReader reader(privateParameters(), ros::this_node::getName());
  const FrameNames frames = readFrameNames(&reader);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  requireScenario(&reader);
  bool base_in_tf = false;
  reader.boolean("base_in_tf", &base_in_tf);
  const std::string description = readDescriptionName(&reader);
  reader.finish();
  requireArm(*scenario);
  const ArmMotion arm(armByDescription(*scenario, description), armMotionParameters(*scenario));
  ros::NodeHandle node;
  constexpr bool kLatched = true;
  const ros::Publisher publisher =
      node.advertise<tf2_msgs::TFMessage>(names::kTfStatic, names::kLatestQueue, kLatched);
  tf2_msgs::TFMessage message;
  message.transforms = {gripTransform(arm, frames)};
  if (!base_in_tf) message.transforms.push_back(baseTransform(arm, scenario->T_world_base, frames));
  publisher.publish(message);
  ros::spin();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) {
  return smore::runNode(argc, argv, "arm_frames", smore::runArmFrames);
}
