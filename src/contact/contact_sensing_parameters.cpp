// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "smore/contact/contact_sensing.h"

namespace smore {
namespace {

SensorNoise readNoise(ParameterReader reader) {
  SensorNoise noise;
  reader.number("force_stddev", &noise.force_stddev, {0.0, 100.0});
  reader.number("torque_stddev", &noise.torque_stddev, {0.0, 100.0});
  reader.number("force_drift", &noise.force_drift, {0.0, 100.0});
  reader.number("sample_period", &noise.sample_period, {1e-5, 1.0});
  reader.number("filter_time_constant", &noise.filter_time_constant, {0.0, 1.0});
  reader.finishNested();
  return noise;
}

Payload readPayload(ParameterReader reader) {
  Payload payload;
  Vec3 center_object = Vec3::Zero();
  reader.number("mass", &payload.mass, {-100.0, 100.0});
  reader.vector("center_of_mass", &center_object, {-10.0, 10.0});
  reader.vector("moment", &payload.moment_object, {-100.0, 100.0});
  payload.moment_object += payload.mass * center_object;
  reader.number("unknown_mass", &payload.unknown_mass, {0.0, 100.0});
  reader.finishNested();
  return payload;
}

TareParameters readTare(ParameterReader reader) {
  TareParameters tare;
  reader.integer("samples", &tare.samples, 2, 100000);
  reader.number("max_force_stddev", &tare.max_force_stddev, {1e-9, 100.0});
  reader.number("max_torque_stddev", &tare.max_torque_stddev, {1e-9, 100.0});
  reader.finishNested();
  return tare;
}

ContactDetectorParameters readDetector(ParameterReader reader) {
  ContactDetectorParameters detector;
  reader.number("contact_force", &detector.contact_force, {1e-3, 1000.0});
  reader.number("free_force", &detector.free_force, {1e-3, 1000.0});
  reader.number("release_force", &detector.release_force, {1e-3, 1000.0});
  reader.number("residual_force", &detector.residual_force, {0.0, 1000.0});
  reader.number("dwell", &detector.dwell, {0.0, 1.0});
  reader.number("release_dwell", &detector.release_dwell, {0.0, 1.0});
  reader.number("fast_window", &detector.fast_window.duration, {0.0, 1.0});
  reader.number("slow_window", &detector.slow_window.duration, {0.0, 10.0});
  detector.release_window = detector.fast_window;
  if (detector.free_force >= detector.contact_force) {
    reader.error("free_force", "must be below contact_force");
  }
  if (detector.release_force > detector.contact_force) {
    reader.error("release_force", "must not be above contact_force");
  }
  reader.finishNested();
  return detector;
}

LineParameters readLine(ParameterReader reader) {
  LineParameters line;
  reader.number("settle", &line.settle, {0.0, 10.0});
  reader.number("window", &line.window.duration, {0.0, 10.0});
  reader.number("patience", &line.patience, {0.0, 10.0});
  reader.number("min_force", &line.min_force, {1e-3, 1000.0});
  reader.number("added_direction_stddev", &line.added_direction_stddev, {0.0, M_PI});
  reader.number("added_offset_stddev", &line.added_offset_stddev, {0.0, 1.0});
  reader.finishNested();
  return line;
}

}  // namespace

ContactSensingParameters readContactSensingParameters(ParameterReader* reader) {
  ContactSensingParameters parameters;
  parameters.noise = readNoise(reader->nested("noise"));
  if (reader->has("payload")) parameters.payload = readPayload(reader->nested("payload"));
  parameters.tare = readTare(reader->nested("tare"));
  parameters.detector = readDetector(reader->nested("detector"));
  parameters.line = readLine(reader->nested("line"));
  return parameters;
}

}  // namespace smore
