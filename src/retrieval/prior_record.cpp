// SPDX-License-Identifier: BSD-3-Clause
#include "prior_record.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "smore/mapping/voxel_runs.h"

namespace smore {
namespace {

const std::vector<std::string> kMaps = {"object", "world"};  // in the order of MapSide

constexpr Range kConfidence{1e-9, 1.0 - 1e-9};
constexpr Range kVoxelSize{1e-6, 10.0};  // [m]

void readRuns(const JsonFields& record, const std::string& key, float probability,
              VoxelGrid* grid) {
  constexpr int kMost = std::numeric_limits<std::uint16_t>::max();
  const Json& runs = record.raw(key);
  const bool whole =
      runs.is_array() && std::all_of(runs.begin(), runs.end(), [](const Json& number) {
        return number.is_number_integer() && number >= -kMost && number <= kMost;
      });
  if (!whole || !setRuns(runs.get<std::vector<std::int32_t>>(), probability, grid)) {
    record.fail(
        key, "expected runs of four whole numbers in the range of voxels; the record is damaged");
  }
}

}  // namespace

Json priorRecord(MapSide side, const Prior& prior) {
  return {{"record", "prior"},
          {"map", kMaps[static_cast<std::size_t>(side)]},
          {"confidence", prior.confidence},
          {"voxel_size", prior.known.voxelSize()},
          {"matter", runsOf(prior.known, true)},
          {"free", runsOf(prior.known, false)}};
}

MapSide readPriorSide(const JsonFields& record) {
  return static_cast<MapSide>(record.choice("map", kMaps));
}

Prior readPrior(const JsonFields& record) {
  Prior prior{VoxelGrid(record.number("voxel_size", kVoxelSize)),
              record.number("confidence", kConfidence)};
  readRuns(record, "matter", 1.0F, &prior.known);
  readRuns(record, "free", 0.0F, &prior.known);
  return prior;
}

}  // namespace smore
