// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

namespace smore {

/// Has the mapping node save both maps in `directory` (absolute) once they hold all that was felt:
/// the observations up to the stamp `felt` [s], and those after it until 0.1 s of them change
/// nothing, since the object may still have come to rest. Maps that do not settle within 2 s of
/// wall time are saved as they are. Why they were not saved; empty where they were.
std::string saveSettledMaps(ros::NodeHandle* node, double felt, const std::string& directory);

}  // namespace smore
