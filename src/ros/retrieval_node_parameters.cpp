// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval_node_parameters.h"

#include <filesystem>

#include "smore/common/output_directory.h"
#include "smore/ros/arm_description.h"
#include "smore/ros/parameter_source.h"

namespace smore {

RetrievalNodeParameters readRetrievalParameters(ParameterReader* reader) {
  RetrievalNodeParameters parameters;
  parameters.frames = readFrameNames(reader);
  parameters.method = readMethod(reader);
  reader->number("silence_timeout", &parameters.robot.silence_timeout, {0.01, 3600.0});
  reader->number("ready_timeout", &parameters.robot.ready_timeout, {0.1, 3600.0});
  if (reader->has("reset_service")) reader->text("reset_service", &parameters.robot.reset_service);
  if (reader->has("zero_service")) reader->text("zero_service", &parameters.robot.zero_service);
  parameters.robot_description = readDescriptionName(reader);
  reader->integer("max_collisions", &parameters.max_collisions, 1, 1000000);
  reader->number("retreat_distance", &parameters.retreat_distance, {1e-3, 10.0});
  reader->boolean("identify_payload", &parameters.identify_payload);
  constexpr double kLeastTilt = 0.35;  // identifyPayload finds nothing below 0.32 [rad]
  reader->number("payload_tilt", &parameters.payload_tilt, {kLeastTilt, 1.0});
  reader->boolean("auto_start", &parameters.auto_start);
  if (reader->has("output")) reader->text("output", &parameters.output);
  if (!parameters.output.empty() && !std::filesystem::path(parameters.output).is_absolute()) {
    reader->error("output", "'" + parameters.output + "' is not an absolute path; give one");
  } else if (!parameters.output.empty()) {
    // Asked before the robot moves: what a run learnt must not be lost at its end.
    const std::string problem = problemOfDirectory(parameters.output);
    if (!problem.empty()) reader->error("output", problem);
  }
  return parameters;
}

}  // namespace smore
