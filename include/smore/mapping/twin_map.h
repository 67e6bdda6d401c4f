// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "smore/contact/contact_observation.h"
#include "smore/mapping/voxel_grid.h"

namespace smore {

/// Two occupancy maps of one voxel size, learnt together from touch: one fixed in the world frame,
/// one that moves with the object frame. Implementations differ in how they infer occupancy; each
/// keeps both maps consistent with one another after every call.
class TwinMap : public ContactObserver {
 public:
  /// Occupancy probabilities in the world frame. A voxel that is not stored is unknown.
  virtual const VoxelGrid& world() const = 0;

  /// Occupancy probabilities in the object frame.
  virtual const VoxelGrid& object() const = 0;

  /// Works out both maps from all observations so far, where that takes time: who asks for them
  /// next then need not wait.
  virtual void update() const {}

  /// Rises whenever a map may have changed: by what was observed alone, whenever somebody asked for
  /// the maps, so that two which were told the same agree in it.
  virtual std::uint64_t revision() const = 0;
};

}  // namespace smore
