// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "smore/contact/line_of_action.h"
#include "smore/planning/planner.h"
#include "smore/ros/conversions.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// One marker for each shape of the true scene: the environment in the world frame, the object in
/// the object frame, so that it moves with the hand. Stamped 0: valid at all times.
visualization_msgs::MarkerArray sceneMarkers(const Scenario& scenario, const FrameNames& frames);

/// The visual shapes of a robot, each in the frame of its link. Meshes are left out. Stamped 0.
visualization_msgs::MarkerArray robotMarkers(const urdf::ModelInterface& urdf);

/// The lines of action as one marker `lines`, each `half_length` [m] to either side of its point,
/// and as one marker `uncertainty` the tubes of two of their standard deviations around them, in
/// the object frame. Here and below lines are as wide as suits maps of `voxel_size` [m].
visualization_msgs::MarkerArray lineMarkers(const std::vector<LineOfAction>& lines,
                                            double half_length, double voxel_size,
                                            const FrameNames& frames);

/// The path as one line in the world frame, coloured at each pose by its entry in `risks` (as many
/// as poses, each in [0, 1]): cyan for 0 to purple for 1.
visualization_msgs::MarkerArray pathMarkers(const Path& path, const std::vector<double>& risks,
                                            double voxel_size, const std::string& frame);

/// The edges of a search as one list of lines in the world frame.
visualization_msgs::MarkerArray treeMarkers(const std::vector<TreeEdge>& tree, double voxel_size,
                                            const std::string& frame);

}  // namespace smore
