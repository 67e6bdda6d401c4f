// SPDX-License-Identifier: BSD-3-Clause
#include "prior_record.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

const std::vector<std::string> kMaps = {"object", "world"};  // in the order of MapSide

constexpr Range kConfidence{1e-9, 1.0 - 1e-9};
constexpr Range kVoxelSize{1e-6, 10.0};  // [m]

// Of a run: x, y and z of its first voxel, and how many there are along x.
constexpr std::size_t kNumbersOfRun = 4;

bool isMatter(const VoxelGrid::Voxel& voxel) { return voxel.probability >= kOccupied; }

Json runsOf(const VoxelGrid& grid, bool matter) {
  std::vector<VoxelKey> keys;
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if (isMatter(voxel) == matter) keys.push_back(voxel.key);
  }
  std::sort(keys.begin(), keys.end(), [](const VoxelKey& a, const VoxelKey& b) {
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
  });
  Json runs = Json::array();
  for (std::size_t first = 0, end = 0; first < keys.size(); first = end) {
    const VoxelKey& key = keys[first];
    for (end = first + 1; end < keys.size(); ++end) {
      const VoxelKey& next = keys[end];
      if (next.z != key.z || next.y != key.y || next.x - key.x != static_cast<int>(end - first)) {
        break;
      }
    }
    for (const int number : {int{key.x}, int{key.y}, int{key.z}, static_cast<int>(end - first)}) {
      runs.push_back(number);
    }
  }
  return runs;
}

void readRuns(const JsonFields& record, const std::string& key, float probability,
              VoxelGrid* grid) {
  constexpr int kMin = std::numeric_limits<std::int16_t>::min();
  constexpr int kMax = std::numeric_limits<std::int16_t>::max();
  const Json& runs = record.raw(key);
  const bool whole = runs.is_array() && runs.size() % kNumbersOfRun == 0 &&
                     std::all_of(runs.begin(), runs.end(), [](const Json& number) {
                       return number.is_number_integer() && number >= kMin && number <= 2 * kMax;
                     });
  if (!whole) record.fail(key, "expected runs of four whole numbers; the record is damaged");
  for (std::size_t i = 0; i < runs.size(); i += kNumbersOfRun) {
    const auto at = [&](std::size_t n) { return runs[i + n].get<int>(); };
    const int count = at(3);
    if (count < 1 || at(0) + count - 1 > kMax || at(0) > kMax || at(1) > kMax || at(2) > kMax) {
      record.fail(key, "a run beyond the range of voxels; the record is damaged");
    }
    for (int n = 0; n < count; ++n) {
      grid->set({static_cast<std::int16_t>(at(0) + n), static_cast<std::int16_t>(at(1)),
                 static_cast<std::int16_t>(at(2))},
                probability);
    }
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
