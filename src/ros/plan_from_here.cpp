// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/plan_from_here.h"

#include <ros/topic.h>

#include "smore/ros/messages.h"
#include "smore/ros/names.h"

namespace smore {

Result<double> planFromHere(const ros::NodeHandle& node, const geometry_msgs::PoseStamped& goal) {
  constexpr double kPatience = 2.0;  // to hear where the object is [s of ROS time]
  ros::NodeHandle own(node);
  const auto here = ros::topic::waitForMessage<smore_msgs::ContactObservation>(
      names::kContact, own, ros::Duration(kPatience));
  if (!here) {
    return Failure{"no contact observation says where the object is; is the listener running?"};
  }
  smore_msgs::PlanPath call;
  call.request.start.header.frame_id = here->world_frame;
  call.request.start.pose = here->pose;
  call.request.goal = goal;
  ros::ServiceClient planner = own.serviceClient<smore_msgs::PlanPath>(names::kPlanPath);
  if (!planner.call(call)) return Failure{"the planner does not answer; is its node up?"};
  if (call.response.success == 0) return Failure{call.response.message};
  return call.response.risk;
}

}  // namespace smore
