// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "smore/mapping/prior.h"
#include "smore/ros/conversions.h"
#include "smore/scenario/prior_source.h"

namespace smore {

/// What somebody tells of one map.
struct PriorRequest {
  MapSide side = MapSide::kWorld;
  PriorSource source;
};

/// Pose of the frame of a cloud, at its stamp, in a frame of ours; else the reason why it is
/// unknown.
using CloudPose =
    std::function<Result<Pose>(const std::string& target, const std_msgs::Header& cloud)>;

/// Of the service `insert_prior`. A cloud in another frame than the map's, without a pose, is
/// placed by `pose_of_cloud`. InputError, with the field and the remedy, for a request that is
/// none: another map, no file and no cloud or both, a relative path, a cloud that is damaged or in
/// a frame unknown, values out of range.
PriorRequest readRequest(const smore_msgs::InsertPrior::Request& request, const FrameNames& frames,
                         const CloudPose& pose_of_cloud);

}  // namespace smore
