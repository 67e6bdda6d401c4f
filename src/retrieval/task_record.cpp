// SPDX-License-Identifier: BSD-3-Clause
#include "task_record.h"

#include <nlohmann/json.hpp>

namespace smore {
namespace {

const std::vector<std::string> kTasks = {"retrieve", "reconstruct"};
const std::vector<std::string> kMotions = {"planar", "spatial"};
const std::vector<std::string> kOnContact = {"reset", "retreat"};

// What the maps can be made with; scenario files are checked more narrowly.
constexpr Range kPositive{1e-9, 1e9};
constexpr Range kNotNegative{0.0, 1e9};
constexpr Range kVoxelSize{1e-4, 10.0};  // [m]
constexpr int kMaxTouches = 1000000;

template <typename Enum>
std::string nameOf(const std::vector<std::string>& names, Enum value) {
  return names[static_cast<std::size_t>(value)];
}

template <typename Enum>
Enum readEnum(const JsonFields& record, const std::string& key,
              const std::vector<std::string>& names) {
  return static_cast<Enum>(record.choice(key, names));
}

Bounds readWorkspace(const JsonFields& record) {
  Bounds workspace{record.vector("min"), record.vector("max")};
  if ((workspace.min.array() > workspace.max.array()).any()) {
    record.fail("min", "above max on an axis; the record is damaged");
  }
  return workspace;
}

void readSensing(const JsonFields& record, Scenario* task) {
  task->contact_force = record.number("contact_force", kPositive);
  task->free_force = record.number("free_force", kPositive);
  const JsonFields noise = record.object("wrench_noise");
  task->wrench_noise.force_stddev = noise.number("force_stddev", kNotNegative);
  task->wrench_noise.torque_stddev = noise.number("torque_stddev", kNotNegative);
  task->wrench_noise.force_drift = noise.number("force_drift", kNotNegative);
  const JsonFields line = record.object("line_noise");
  task->line_noise.direction = line.number("direction", kNotNegative);
  task->line_noise.offset = line.number("offset", kNotNegative);
}

}  // namespace

Json taskRecord(const Scenario& scenario) {
  return {
      {"record", "task"},
      {"name", scenario.name},
      {"task", nameOf(kTasks, scenario.task)},
      {"voxel_size", scenario.voxel_size},
      {"motion", nameOf(kMotions, scenario.motion)},
      {"robot", robotName(scenario.robot)},
      {"start", toJson(scenario.start)},
      {"goal", toJson(scenario.goal)},
      {"goal_tolerance",
       {{"position", scenario.goal_position_tolerance}, {"angle", scenario.goal_angle_tolerance}}},
      {"workspace",
       {{"min", toJson(scenario.workspace.min)}, {"max", toJson(scenario.workspace.max)}}},
      {"speed", {{"linear", scenario.linear_speed}, {"angular", scenario.angular_speed}}},
      {"on_contact", nameOf(kOnContact, scenario.on_contact)},
      {"touches", scenario.reconstruct_touches},
      {"contact_force", scenario.contact_force},
      {"free_force", scenario.free_force},
      {"wrench_noise",
       {{"force_stddev", scenario.wrench_noise.force_stddev},
        {"torque_stddev", scenario.wrench_noise.torque_stddev},
        {"force_drift", scenario.wrench_noise.force_drift}}},
      {"line_noise",
       {{"direction", scenario.line_noise.direction}, {"offset", scenario.line_noise.offset}}}};
}

Scenario readTask(const JsonFields& record) {
  Scenario task;
  task.name = record.text("name");
  task.task = readEnum<Task>(record, "task", kTasks);
  task.voxel_size = record.number("voxel_size", kVoxelSize);
  task.motion = readEnum<Motion>(record, "motion", kMotions);
  task.robot = readEnum<RobotKind>(record, "robot", robotNames());
  task.start = record.pose("start");
  task.goal = record.pose("goal");
  const JsonFields tolerance = record.object("goal_tolerance");
  task.goal_position_tolerance = tolerance.number("position", kPositive);
  task.goal_angle_tolerance = tolerance.number("angle", kPositive);
  task.workspace = readWorkspace(record.object("workspace"));
  const JsonFields speed = record.object("speed");
  task.linear_speed = speed.number("linear", kPositive);
  task.angular_speed = speed.number("angular", kPositive);
  task.on_contact = readEnum<OnContact>(record, "on_contact", kOnContact);
  task.reconstruct_touches = record.integer("touches", 1, kMaxTouches);
  readSensing(record, &task);
  return task;
}

}  // namespace smore
