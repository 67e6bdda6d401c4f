// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/belief_files.h"

#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "smore/common/result.h"
#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

namespace fs = std::filesystem;

const char* variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

// Planes so near to each other are one: below what the calibration of an arm repeats. Ours.
constexpr double kPlaneHeight = 0.005;  // [m]
constexpr double kPlaneTilt = 0.02;     // [rad]

bool inOnePlane(const Pose& T_world_one, const Pose& T_world_other) {
  const Pose T_one_other = T_world_one.inverse() * T_world_other;
  return std::abs(T_one_other.translation().z()) <= kPlaneHeight &&
         T_one_other.linear().col(2).head<2>().norm() <= kPlaneTilt &&
         T_one_other.linear()(2, 2) > 0.0;
}

std::string motionName(Motion motion) { return motion == Motion::kPlanar ? "planar" : "spatial"; }

}  // namespace

std::string belowRosHome(const std::string& path) {
  if (const char* ros_home = variable("ROS_HOME")) return (fs::path(ros_home) / path).string();
  const char* home = variable("HOME");
  return (fs::path(home != nullptr ? home : "/") / ".ros" / path).string();
}

void saveMaps(const MapKeeper& keeper, const std::string& directory) {
  const fs::path folder(directory);
  if (!folder.is_absolute()) {
    throw InputError("'" + directory + "' is not an absolute path; give one");
  }
  std::error_code problem;
  fs::create_directories(folder, problem);
  std::unique_ptr<octomap::OcTree> world, object;
  keeper.access([&](const MapState& state) {
    world = toOctree(state.maps->world());
    object = toOctree(state.maps->object());
  });
  if (problem) {
    throw std::runtime_error("cannot write into '" + directory +
                             "'; check that it is a directory that may be written");
  }
  writeOctree(*world, folder / "world.ot");
  writeOctree(*object, folder / "object.ot");
}

BeliefFiles::BeliefFiles(std::string folder, EvidenceSource source)
    : folder_(std::move(folder)), source_(std::move(source)) {}

std::string BeliefFiles::save(const MapKeeper& keeper, const std::string& name,
                              bool overwrite) const {
  std::string file = pathOf(name);
  if (!overwrite && fs::exists(file)) {
    throw InputError("'" + file + "' is there already; give another name, or set overwrite");
  }
  std::error_code problem;
  fs::create_directories(fs::path(file).parent_path(), problem);
  EvidenceSource source = source_;
  std::vector<ContactObservation> observations;
  keeper.access([&](const MapState& state) {
    source.priors = state.priors;
    observations = state.log.from(0);
  });
  writeEvidence(file, source, observations);
  return file;
}

std::string BeliefFiles::load(const std::string& name, MapKeeper* keeper) const {
  return loadFrom(pathOf(name), keeper);
}

std::string BeliefFiles::loadFrom(const std::string& file, MapKeeper* keeper) const {
  const Evidence evidence = readEvidence(file, MethodParameters{});  // the node has its own
  const Motion motion = evidence.source.task.motion;
  if (motion != source_.task.motion) {
    throw InputError(file + ": recorded in " + motionName(motion) + " motion, this task is " +
                     motionName(source_.task.motion) + "; load evidence of the same kind");
  }
  if (motion == Motion::kPlanar && !inOnePlane(source_.task.start, evidence.source.task.start)) {
    throw InputError(file + ": recorded in another plane of motion than that of this task; load " +
                     "evidence whose start lies in it");
  }
  keeper->load(evidence.source.priors, evidence.observations);
  const auto lines = std::count_if(evidence.observations.begin(), evidence.observations.end(),
                                   [](const auto& observation) { return bool(observation.line); });
  return "loaded " + std::to_string(evidence.observations.size()) + " observations with " +
         std::to_string(lines) + " lines of action from " + file +
         (evidence.whole ? "" : "; its last record was cut and is left out");
}

std::string BeliefFiles::pathOf(const std::string& name) const {
  const fs::path given(name);
  const bool leaves = std::find(given.begin(), given.end(), "..") != given.end();
  if (given.filename().empty() || given.is_absolute() || leaves) {
    throw InputError("'" + name + "' is not the name of a file below " + folder_ +
                     "; give a relative path without '..'");
  }
  fs::path path = fs::path(folder_) / given;
  if (path.extension() != ".evidence") path += ".evidence";
  return path.string();
}

}  // namespace smore
