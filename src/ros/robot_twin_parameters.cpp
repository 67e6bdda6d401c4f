// SPDX-License-Identifier: BSD-3-Clause
#include "robot_twin_parameters.h"

#include <limits>

#include "smore/ros/parameter_source.h"

namespace smore {

TwinParameters readTwinParameters(ParameterReader* reader) {
  TwinParameters parameters;
  parameters.frames = readFrameNames(reader);
  reader->integer("seed", &parameters.seed, 0, std::numeric_limits<int>::max());
  reader->number("sensor_cutoff", &parameters.sensor_cutoff, {0.0, 1000.0});
  reader->number("stop_duration", &parameters.stop_duration, {0.0, 5.0});
  reader->number("latency_min", &parameters.latency_min, {0.0, 1.0});
  reader->number("latency_max", &parameters.latency_max, {0.0, 1.0});
  reader->number("stamp_jitter", &parameters.stamp_jitter, {0.0, 0.1});
  reader->number("slider", &parameters.slider, {0.0, 1.0});
  reader->number("zero_delay", &parameters.zero_delay, {0.0, 10.0});
  reader->number("calibration", &parameters.calibration, {0.0, 0.005});
  reader->boolean("described", &parameters.described);
  reader->vector("tcp", &parameters.pendant.tcp, {-1.0, 1.0});
  reader->number("payload_mass", &parameters.pendant.payload_mass, {0.0, 20.0});
  reader->vector("payload_center", &parameters.pendant.payload_center, {-1.0, 1.0});
  if (parameters.latency_max < parameters.latency_min) {
    reader->error("latency_max", "is less than latency_min; give at least as much");
  }
  return parameters;
}

}  // namespace smore
