// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <string>
#include <vector>

#include "smore/planning/occupied_voxels.h"
#include "smore/planning/planner.h"
#include "smore/ros/revised_topic.h"

namespace smore {

/// A plan, and what there is to see of it.
struct ShownPlan {
  Path path;                   ///< T_world_object, its poses near together, as densify makes them
  std::vector<double> risks;   ///< of each pose: to have touched on the way so far, in [0, 1]
  OccupiedVoxels object;       ///< as it is known, in the object frame
  std::vector<TreeEdge> tree;  ///< what the search explored
};

/// The last plan for the eye, each part on a topic that sends only what somebody looks at: who
/// begins to look after the plan was made sees it too.
class PlanDisplay {
 public:
  /// Beside voxels of `voxel_size` [m], in the world frame `frame`. The queue of `node` is called
  /// by the thread that shows.
  PlanDisplay(const ros::NodeHandle& node, double voxel_size, const std::string& frame);

  void show(ShownPlan plan);

 private:
  void send();

  double voxel_size_;
  std::string frame_;
  ros::NodeHandle node_;
  ShownPlan plan_;
  std::uint64_t plans_ = 0;  ///< that were shown
  RevisedTopic path_, ghost_, tree_;
};

}  // namespace smore
