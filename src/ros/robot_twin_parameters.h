// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/parameters.h"
#include "smore/ros/conversions.h"
#include "smore/simulation/driver_wrench.h"

namespace smore {

/// How the twin of a driver behaves; config/robot_twin.yaml explains each.
struct TwinParameters {
  FrameNames frames;
  int seed = 1;
  double sensor_cutoff = 0.0;  ///< [Hz]; 0: none
  double stop_duration = 0.5;  ///< of the controller's ramp [s]
  double latency_min = 0.002;  ///< of each way [s]
  double latency_max = 0.002;  ///< [s]
  double stamp_jitter = 0.0;   ///< standard deviation [s]
  double slider = 1.0;         ///< of the robot's speed at the start, 0 to 1
  double zero_delay = 0.2;     ///< [s]; the zero is the mean over it
  double calibration = 0.0;    ///< standard deviation of each joint's place [m] and turn [rad]
  bool described = true;       ///< whether robot_description has that calibration
  PendantSettings pendant;
};

/// Errors are noted in `reader`.
TwinParameters readTwinParameters(ParameterReader* reader);

}  // namespace smore
