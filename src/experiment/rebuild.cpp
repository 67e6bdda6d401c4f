// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/rebuild.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "smore/common/json_lines.h"
#include "smore/common/version.h"
#include "smore/experiment/map_files.h"
#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

std::size_t contactCount(const Evidence& evidence) {
  std::set<int> ids;
  for (const ContactObservation& observation : evidence.observations) {
    if (observation.state == ContactState::kContact) ids.insert(observation.contact_id);
  }
  return ids.size();
}

Json mapJson(const VoxelGrid& grid) {
  const auto occupied =
      std::count_if(grid.voxels().begin(), grid.voxels().end(),
                    [](const VoxelGrid::Voxel& voxel) { return voxel.probability >= kOccupied; });
  return {{"voxels", grid.size()}, {"occupied", occupied}};
}

Json summaryJson(const Evidence& evidence, const TwinMap& maps) {
  const EvidenceSource& source = evidence.source;
  Json json{{"evidence", evidence.file},
            {"recorded_by", evidence.program},
            {"program", std::string("smore ") + programVersion()},
            {"scenario", source.task.name},
            {"method", methodName(source.method)},
            {"seed", source.seed},
            {"voxel_size", source.task.voxel_size},
            {"whole", evidence.whole},
            {"observations", evidence.observations.size()},
            {"contacts", contactCount(evidence)},
            {"motions", evidence.motions.size()},
            {"world_map", mapJson(maps.world())},
            {"object_map", mapJson(maps.object())}};
  if (takesParameters(source.method)) {
    json["parameters"] = toJson(source.method, source.parameters);
  }
  return json;
}

}  // namespace

void rebuild(Evidence evidence, const RebuildChanges& changes, const std::string& directory) {
  EvidenceSource& source = evidence.source;
  source.method = changes.method.value_or(source.method);
  source.task.voxel_size = changes.voxel_size.value_or(source.task.voxel_size);
  Method method =
      makeMethod(source.method, source.task, source.seed, source.parameters, source.priors);
  replay(evidence, &method);
  saveMaps(*method.maps, directory);
  const std::string file = directory + "/summary.json";
  std::ofstream stream(file);
  stream << textOf(summaryJson(evidence, *method.maps)) << std::endl;
  if (!stream) throw std::runtime_error(file + ": cannot be written; check the disk");
}

}  // namespace smore
