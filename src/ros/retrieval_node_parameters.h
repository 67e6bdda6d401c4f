// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/common/parameters.h"
#include "smore/retrieval/method.h"
#include "smore/ros/conversions.h"
#include "smore/ros/ros_robot.h"

namespace smore {

/// How the retrieval node goes about a goal; config/retrieval.yaml explains each.
struct RetrievalNodeParameters {
  FrameNames frames;
  MethodKind method = MethodKind::kSmore;  ///< for the summary; the planner decides
  RosRobotParameters robot;
  std::string robot_description;  ///< global parameter with the arm's description; empty: nominal
  int max_collisions = 2000;
  double retreat_distance = 0.05;  ///< [m + rad]
  bool identify_payload = true;    ///< at the start, where the robot tilts it
  double payload_tilt = 0.5;       ///< [rad]
  bool auto_start = false;
  std::string output;  ///< directory for maps and summary; empty: none
};

/// Errors are noted in `reader`.
RetrievalNodeParameters readRetrievalParameters(ParameterReader* reader);

}  // namespace smore
