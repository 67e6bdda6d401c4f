// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "smore/mapping/known_matter.h"
#include "smore/mapping/voxel_grid.h"
#include "smore/mapping/worlds.h"

namespace smore {

/// Occupancy as the sampled worlds have it on one of their sides, in the world or the object frame.
/// A voxel's probability is the share of the worlds with a ball that holds the voxel's centre, or
/// whose centre the voxel holds. Matter outside of the range of voxel keys is left out.
VoxelGrid marginalMap(const Worlds& worlds, MapSide side, double voxel_size);

/// The two marginal maps of a belief, made when they are first asked for: small voxels take long
/// and much memory, and plans do without. Several threads may ask.
class MarginalMaps {
 public:
  /// `voxel_size` [m], positive.
  explicit MarginalMaps(double voxel_size) : voxel_size_(voxel_size) {}

  /// `worlds` not null. What was given for a side before is no longer valid where the worlds are
  /// others.
  const VoxelGrid& of(const std::shared_ptr<const Worlds>& worlds, MapSide side);

 private:
  struct Made {
    std::weak_ptr<const Worlds> of;  ///< these are large: maps do not keep them
    std::optional<VoxelGrid> map;
  };

  double voxel_size_;
  std::unique_ptr<std::mutex> making_ = std::make_unique<std::mutex>();
  std::map<MapSide, Made> made_;
};

}  // namespace smore
