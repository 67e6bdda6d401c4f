// SPDX-License-Identifier: BSD-3-Clause
#include "force_torque_parameters.h"

#include "smore/ros/parameter_source.h"

namespace smore {
namespace {

void imposeScenario(const Scenario& scenario, YAML::Node parameters, ParameterReader* reader) {
  const auto impose = [&](const char* group, const char* key, double value) {
    imposeScenarioValue(parameters, group, key, value, reader);
  };
  impose("detector", "contact_force", scenario.contact_force);
  impose("detector", "free_force", scenario.free_force);
  impose("noise", "force_stddev", scenario.wrench_noise.force_stddev);
  impose("noise", "torque_stddev", scenario.wrench_noise.torque_stddev);
  impose("noise", "force_drift", scenario.wrench_noise.force_drift);
  impose("line", "added_direction_stddev", scenario.line_noise.direction);
  impose("line", "added_offset_stddev", scenario.line_noise.offset);
}

}  // namespace

ForceTorqueParameters readForceTorqueParameters(const YAML::Node& mapping,
                                                const std::string& source) {
  ParameterReader reader(mapping, source);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  // After a scenario that cannot be read, its error is all there is to say.
  if (reader.has("scenario")) imposeScenario(scenario.value_or(Scenario()), mapping, &reader);
  ForceTorqueParameters parameters;
  parameters.frames = readFrameNames(&reader);
  parameters.axes = readWrenchAxes(&reader);
  reader.number("transform_timeout", &parameters.transform_timeout, {0.01, 60.0});
  reader.number("silence_timeout", &parameters.silence_timeout, {0.01, 3600.0});
  reader.number("tare_timeout", &parameters.tare_timeout, {0.1, 3600.0});
  parameters.sensing = readContactSensingParameters(&reader);
  if (scenario) parameters.range = wristSensorRange(scenario->robot);
  if (scenario && !tiltsPayload(*scenario)) parameters.sensing.payload.unknown_mass = 0.0;
  if (reader.has("record")) reader.text("record", &parameters.record);
  reader.finish();
  return parameters;
}

std::string toYaml(const ForceTorqueParameters& parameters, const YAML::Node& mapping) {
  YAML::Node whole = YAML::Clone(mapping);
  for (const char* key : {"scenario", "scenario_directory", "record"}) whole.remove(key);
  whole["payload"]["unknown_mass"] = parameters.sensing.payload.unknown_mass;
  return YAML::Dump(whole);
}

}  // namespace smore
