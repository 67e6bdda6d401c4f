// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/plan_display.h"

#include <visualization_msgs/MarkerArray.h>

#include <utility>

#include "smore/ros/ghost_markers.h"
#include "smore/ros/scene_markers.h"

namespace smore {

PlanDisplay::PlanDisplay(const ros::NodeHandle& node, double voxel_size, const std::string& frame)
    : voxel_size_(voxel_size), frame_(frame), node_(node) {
  const auto on_listener = [this](const ros::SingleSubscriberPublisher& /*listener*/) { send(); };
  path_.open<visualization_msgs::MarkerArray>(&node_, names::kPathMarkers, on_listener);
  ghost_.open<visualization_msgs::MarkerArray>(&node_, names::kPathGhost, on_listener);
  tree_.open<visualization_msgs::MarkerArray>(&node_, names::kPlanTree, on_listener);
}

void PlanDisplay::show(ShownPlan plan) {
  plan_ = std::move(plan);
  ++plans_;
  send();
}

void PlanDisplay::send() {
  if (plans_ == 0) return;
  path_.send(plans_, [&] { return pathMarkers(plan_.path, plan_.risks, voxel_size_, frame_); });
  ghost_.send(plans_, [&] { return ghostMarkers(plan_.path, plan_.risks, plan_.object, frame_); });
  tree_.send(plans_, [&] { return treeMarkers(plan_.tree, voxel_size_, frame_); });
}

}  // namespace smore
