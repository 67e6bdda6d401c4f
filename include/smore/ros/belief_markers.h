// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "smore/mapping/worlds.h"
#include "smore/ros/conversions.h"

namespace smore {

/// Where each contact may have been, each place once, in the object frame `frame`, as one marker:
/// from yellow to black by the share of the worlds in which its contact was there. Half as large as
/// the balls of matter that are assumed there.
visualization_msgs::MarkerArray placeMarkers(const Worlds& worlds, const std::string& frame);

/// One of the sampled worlds, by its number from 1 to kHypotheses: its balls of matter on either
/// side as they are, one marker for each side and for what was touched, in space lies behind
/// touches of the object, or was known beforehand, and its number as text at the object. Before
/// them one that deletes what was shown; that alone for another number, and in a world without
/// matter.
visualization_msgs::MarkerArray sampledWorldMarkers(const Worlds& worlds, int number,
                                                    const FrameNames& frames);

}  // namespace smore
