// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/scenario.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "prior_reader.h"
#include "shape_reader.h"
#include "smore/common/parameters.h"
#include "smore/common/result.h"
#include "smore/common/yaml_file.h"

namespace smore {
namespace {

// Limits of sense: they catch wrong units, not unusual scenes.
constexpr Range kVoxelSize{1e-3, 1.0};           // [m]
constexpr Range kPositionTolerance{1e-6, 10.0};  // [m]
constexpr Range kAngleTolerance{1e-6, M_PI};     // [rad]
constexpr Range kFriction{0.0, 10.0};
constexpr Range kSpeed{1e-4, 10.0};  // [m/s], [rad/s]
constexpr Range kForce{1e-3, 1e4};   // [N]
constexpr Range kNoise{0.0, 1e3};    // [N], [N m], [rad], [m]
constexpr Range kBias{-1e3, 1e3};    // [N], [N m]
constexpr Range kMass{1e-3, 100.0};  // [kg]
constexpr int kMaxTouches = 1000000;

// OctoMap numbers the voxels of each axis with 16 bits, half of them on either side of zero.
constexpr double kVoxelsPerHalfAxis = 32768.0;
// The laws look along a line of action so far to either side of the object's origin [m].
constexpr double kLineReach = 1.0;

using ReadSection = std::function<void(ParameterReader*)>;

void ifGiven(ParameterReader* reader, const std::string& key, const ReadSection& read) {
  if (!reader->has(key)) return;
  ParameterReader section = reader->nested(key);
  read(&section);
  section.finishNested();
}

void angleIfGiven(ParameterReader* reader, const std::string& key, double* value, Range range) {
  if (reader->has(key)) reader->angle(key, value, range);
}

void numberIfGiven(ParameterReader* reader, const std::string& key, double* value, Range range) {
  if (reader->has(key)) reader->number(key, value, range);
}

void vectorIfGiven(ParameterReader* reader, const std::string& key, Vec3* value, Range range) {
  if (reader->has(key)) reader->vector(key, value, range);
}

template <typename Enum>
void readChoice(ParameterReader* reader, const std::string& key,
                const std::vector<std::string>& choices, Enum* value) {
  int index = static_cast<int>(*value);
  reader->choice(key, choices, &index);
  *value = static_cast<Enum>(index);
}

void readPoseAt(ParameterReader* reader, const std::string& key, Pose* pose) {
  ParameterReader section = reader->nested(key);
  if (!reader->has(key)) return;
  *pose = readPose(&section);
  section.finishNested();
}

void readTask(ParameterReader* reader, Scenario* scenario) {
  reader->text("name", &scenario->name);
  readChoice(reader, "task", {"retrieve", "reconstruct"}, &scenario->task);
  reader->number("voxel_size", &scenario->voxel_size, kVoxelSize);
  readChoice(reader, "motion", {"planar", "spatial"}, &scenario->motion);
  readPoseAt(reader, "start", &scenario->start);
  readPoseAt(reader, "goal", &scenario->goal);
  ifGiven(reader, "goal_tolerance", [scenario](ParameterReader* section) {
    numberIfGiven(section, "position", &scenario->goal_position_tolerance, kPositionTolerance);
    angleIfGiven(section, "angle", &scenario->goal_angle_tolerance, kAngleTolerance);
  });
}

// Arms that we know are named, others given by the path of their description.
void readRobot(ParameterReader* reader, const std::string& directory, Scenario* scenario) {
  const std::string ending = ".urdf";
  std::string text;
  if (reader->has("robot")) reader->text("robot", &text);
  const bool is_path = text.size() > ending.size() &&
                       text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
  if (!is_path) {
    std::vector<std::string> choices = robotNames();
    choices.back() = "FILE" + ending;
    return readChoice(reader, "robot", choices, &scenario->robot);
  }
  scenario->robot = RobotKind::kUrdf;
  scenario->robot_urdf = text.front() == '/' ? text : directory + text;
}

void readWorkspace(ParameterReader* reader, Bounds* workspace) {
  ParameterReader section = reader->nested("workspace");
  if (!reader->has("workspace")) return;
  section.vector("min", &workspace->min);
  section.vector("max", &workspace->max);
  section.finishNested();
  if ((workspace->min.array() > workspace->max.array()).any()) {
    reader->error("workspace", "min is above max; give min first on every axis");
  }
}

// A task has neither; where one is given the other one is missed.
void readScene(ParameterReader* reader, const std::string& directory, Scenario* scenario) {
  const bool has_object = reader->has("object");
  const bool has_environment = reader->has("environment");
  if (!has_object && !has_environment) return;
  scenario->object = readShapes(reader, "object", directory, true);
  scenario->environment = readShapes(reader, "environment", directory, false);
}

void readContact(ParameterReader* reader, Scenario* scenario) {
  numberIfGiven(reader, "friction", &scenario->friction, kFriction);
  numberIfGiven(reader, "object_mass", &scenario->object_mass, kMass);
  ifGiven(reader, "speed", [scenario](ParameterReader* section) {
    numberIfGiven(section, "linear", &scenario->linear_speed, kSpeed);
    numberIfGiven(section, "angular", &scenario->angular_speed, kSpeed);
  });
  numberIfGiven(reader, "contact_force", &scenario->contact_force, kForce);
  numberIfGiven(reader, "free_force", &scenario->free_force, kForce);
  if (scenario->free_force >= scenario->contact_force) {
    reader->error("free_force", "not below contact_force; lower free_force or raise contact_force");
  }
}

void readWrenchNoise(ParameterReader* reader, WrenchNoise* noise) {
  numberIfGiven(reader, "force_stddev", &noise->force_stddev, kNoise);
  numberIfGiven(reader, "torque_stddev", &noise->torque_stddev, kNoise);
  vectorIfGiven(reader, "force_bias", &noise->force_bias, kBias);
  vectorIfGiven(reader, "torque_bias", &noise->torque_bias, kBias);
  numberIfGiven(reader, "force_drift", &noise->force_drift, kNoise);
}

void readTrial(ParameterReader* reader, Scenario* scenario) {
  ifGiven(reader, "wrench_noise", [scenario](ParameterReader* section) {
    readWrenchNoise(section, &scenario->wrench_noise);
  });
  ifGiven(reader, "line_noise", [scenario](ParameterReader* section) {
    angleIfGiven(section, "direction", &scenario->line_noise.direction, kNoise);
    numberIfGiven(section, "offset", &scenario->line_noise.offset, kNoise);
  });
  if (reader->has("on_contact")) {
    readChoice(reader, "on_contact", {"reset", "retreat"}, &scenario->on_contact);
  }
  ifGiven(reader, "reconstruct", [scenario](ParameterReader* section) {
    section->integer("touches", &scenario->reconstruct_touches, 1, kMaxTouches);
  });
  ifGiven(reader, "perturb", [scenario](ParameterReader* section) {
    numberIfGiven(section, "position", &scenario->perturb.position, {0.0, 10.0});
    angleIfGiven(section, "angle", &scenario->perturb.angle, {0.0, M_PI});
  });
}

void readArm(ParameterReader* reader, Scenario* scenario) {
  if (reader->has("robot_base")) readPoseAt(reader, "robot_base", &scenario->T_world_base);
  if (reader->has("gripper_object")) {
    readPoseAt(reader, "gripper_object", &scenario->T_gripper_object);
  }
}

void checkVoxelKeys(ParameterReader* reader, const Scenario& scenario) {
  const double reach = std::max(reachOf(scenario.object), kLineReach);
  if (!std::isfinite(reach)) return;  // a mesh that could not be read
  const double limit = kVoxelsPerHalfAxis * scenario.voxel_size - reach;
  const Bounds& workspace = scenario.workspace;
  if (workspace.min.minCoeff() >= -limit && workspace.max.maxCoeff() <= limit) return;
  std::ostringstream problem;
  problem << "beyond what octrees with voxels of " << scenario.voxel_size << " m can hold; keep it "
          << "from " << -limit << " to " << limit << " m on each axis, or raise voxel_size";
  reader->error("workspace", problem.str());
}

void checkInSpace(ParameterReader* reader, const Scenario& scenario) {
  const auto check = [&](const std::string& key, const Pose& pose) {
    if (!scenario.workspace.contains(pose.translation())) {
      reader->error(key, "outside of the workspace; move it or widen workspace.min and max");
    } else if (!scenario.motionSpace().contains(pose)) {
      reader->error(key, scenario.motionSpace().whyOutside(pose) +
                             ", the x-y plane of the start pose; move it or use motion: spatial");
    }
  };
  check("start", scenario.start);
  check("goal", scenario.goal);
}

}  // namespace

const std::vector<std::string>& robotNames() {
  static const std::vector<std::string> names = {"cartesian", "ur3e",  "ur5e",
                                                 "ur10e",     "ur16e", "urdf"};
  return names;
}

const std::string& robotName(RobotKind kind) {
  return robotNames()[static_cast<std::size_t>(kind)];
}

bool isArm(RobotKind kind) { return kind != RobotKind::kCartesian; }

std::vector<std::string> filesOf(const Scenario& scenario) {
  std::vector<std::string> files;
  const auto add = [&files](const std::string& file) {
    if (!file.empty()) files.push_back(file);
  };
  for (const auto* shapes : {&scenario.object, &scenario.environment}) {
    for (const Shape& shape : *shapes) {
      if (const auto* mesh = std::get_if<MeshShape>(&shape.geometry)) add(mesh->file);
    }
  }
  for (const auto* sources : {&scenario.prior.object, &scenario.prior.world}) {
    for (const PriorSource& source : *sources) add(source.file);
  }
  add(scenario.robot_urdf);
  return files;
}

double reachOf(const std::vector<Shape>& object) {
  const Bounds bounds = boundsOf(object);
  return bounds.min.cwiseAbs().cwiseMax(bounds.max.cwiseAbs()).norm();
}

Bounds regionOfContacts(const Scenario& scenario) {
  const Vec3 reach = Vec3::Constant(reachOf(scenario.object));
  return {scenario.workspace.min - reach, scenario.workspace.max + reach};
}

void requireScene(const Scenario& scenario) {
  if (scenario.hasScene()) return;
  throw InputError("scenario " + scenario.name +
                   ": object, environment: missing; without shapes it is a task for a real robot "
                   "(robot.launch), give the shapes of both to simulate it");
}

const std::string& robotText(const Scenario& scenario) {
  return scenario.robot == RobotKind::kUrdf ? scenario.robot_urdf : robotName(scenario.robot);
}

void requireArm(const Scenario& scenario) {
  if (isArm(scenario.robot)) return;
  throw InputError("scenario " + scenario.name + ": robot: " + robotText(scenario) +
                   " is not an arm; use one of ur3e, ur5e, ur10e, ur16e, or the path of a URDF");
}

bool tiltsPayload(const Scenario& scenario) {
  return isArm(scenario.robot) && scenario.motion == Motion::kSpatial;
}

Scenario loadScenario(const std::string& file) {
  ParameterReader reader(loadYaml(file), file);
  const std::string directory = file.substr(0, file.find_last_of('/') + 1);
  Scenario scenario;
  readTask(&reader, &scenario);
  readRobot(&reader, directory, &scenario);
  readScene(&reader, directory, &scenario);
  readWorkspace(&reader, &scenario.workspace);
  readContact(&reader, &scenario);
  readTrial(&reader, &scenario);
  readArm(&reader, &scenario);
  scenario.prior = readPriorSources(&reader, directory);
  if (reader.has("start") && reader.has("goal") && reader.has("workspace")) {
    checkInSpace(&reader, scenario);
    checkVoxelKeys(&reader, scenario);
  }
  reader.finish();
  return scenario;
}

}  // namespace smore
