// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "smore/planning/occupied_voxels.h"

namespace smore {

/// Whether the object may be at a pose, and the probability that it touches there.
struct PoseAssessment {
  bool valid = false;
  double risk = 0.0;    ///< in [0, 1]; for methods without risk 0 where valid, else 1
  std::string problem;  ///< why it is not valid, in words; empty where it is
};

/// What is known of the object and of where it may be, all of one moment: a value for any thread.
struct PoseKnowledge {
  OccupiedVoxels object;  ///< to be drawn: those with P >= 0.3, in the object frame
  /// Of a pose T_world_object; from any thread.
  std::function<PoseAssessment(const Pose&)> assess;
};

}  // namespace smore
