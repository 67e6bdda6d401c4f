// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/voxel_pairing.h"

#include <algorithm>
#include <tuple>

namespace smore {
namespace {

struct Candidate {
  PairedVoxels pair;
  double squared_distance;  ///< of the centres, in the object frame [m^2]
  std::size_t order;
};

bool betterForPartner(const Candidate& a, const Candidate& b) {
  return std::tie(a.pair.object, a.squared_distance, a.pair.world) <
         std::tie(b.pair.object, b.squared_distance, b.pair.world);
}

bool samePartner(const Candidate& a, const Candidate& b) { return a.pair.object == b.pair.object; }

}  // namespace

std::vector<PairedVoxels> pairVoxels(const std::vector<VoxelKey>& world_keys,
                                     const Pose& T_world_object, double voxel_size) {
  const Pose T_object_world = T_world_object.inverse();
  std::vector<Candidate> candidates;
  candidates.reserve(world_keys.size());
  for (const VoxelKey& world : world_keys) {
    const Vec3 center_object = T_object_world * voxelCenter(world, voxel_size);
    const VoxelKey object = voxelAt(center_object, voxel_size);
    const double distance = (center_object - voxelCenter(object, voxel_size)).squaredNorm();
    candidates.push_back({{world, object}, distance, candidates.size()});
  }
  std::sort(candidates.begin(), candidates.end(), betterForPartner);
  candidates.erase(std::unique(candidates.begin(), candidates.end(), samePartner),
                   candidates.end());
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.order < b.order; });

  std::vector<PairedVoxels> pairs;
  pairs.reserve(candidates.size());
  for (const Candidate& candidate : candidates) pairs.push_back(candidate.pair);
  return pairs;
}

}  // namespace smore
