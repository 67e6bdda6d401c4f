// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "smore/planning/occupied_voxels.h"

namespace smore {

/// The object as it is known, translucent, at poses evenly chosen along `path` (T_world_object, its
/// poses near together, as densify makes them), first and last included, each coloured by its entry
/// in `risks` as riskColor has it (as many as poses, each in [0, 1]). One marker a pose, in the
/// world frame `frame`, after one that deletes those of an earlier path; nothing is drawn of an
/// object that nothing is known of.
visualization_msgs::MarkerArray ghostMarkers(const Path& path, const std::vector<double>& risks,
                                             const OccupiedVoxels& object,
                                             const std::string& frame);

}  // namespace smore
