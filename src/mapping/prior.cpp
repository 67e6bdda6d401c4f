// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/prior.h"

#include <algorithm>

#include "smore/mapping/octomap_export.h"

namespace smore {

bool areTheSame(const Prior& a, const Prior& b) {
  if (a.confidence != b.confidence || a.known.voxelSize() != b.known.voxelSize() ||
      a.known.size() != b.known.size()) {
    return false;
  }
  return std::all_of(a.known.voxels().begin(), a.known.voxels().end(),
                     [&b](const VoxelGrid::Voxel& voxel) {
                       const auto other = b.known.probability(voxel.key);
                       return other && (*other >= kOccupied) == (voxel.probability >= kOccupied);
                     });
}

}  // namespace smore
