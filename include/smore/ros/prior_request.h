// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/prior.h"
#include "smore/ros/conversions.h"
#include "smore/scenario/prior_source.h"

namespace smore {

/// What somebody tells of one map.
struct PriorRequest {
  MapSide side = MapSide::kWorld;
  PriorSource source;
};

/// Of the service `insert_prior`. InputError, with the field and the remedy, for a request that is
/// none: another map, no file and no cloud or both, a relative path, a cloud that is damaged or in
/// another frame, values out of range.
PriorRequest readRequest(const smore_msgs::InsertPrior::Request& request, const FrameNames& frames);

}  // namespace smore
