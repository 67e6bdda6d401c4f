// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "smore/mapping/free_cells.h"
#include "smore/mapping/joint_distribution.h"
#include "smore/mapping/map_frame.h"
#include "smore/mapping/sampled_worlds.h"
#include "smore/mapping/voxel_grid.h"

namespace smore {

/// All that a joint belief says at one moment. A value: it stays as it is while the belief learns
/// on, and threads may share it.
struct Worlds {
  MapFrame frame;             ///< of the sampled worlds and the free cells
  FeatureParameters feature;  ///< what a touch was assumed to be
  FreeCells free;             ///< where the object was free
  std::size_t contacts = 0;   ///< observed so far, those that were merged included
  std::uint64_t resets = 0;   ///< how often the belief had forgotten everything

  std::vector<Explanation>
      explanations;       ///< kHypotheses of them, of the contacts kept by their ids
  SampledWorlds sampled;  ///< the same with the matter that follows from them
  VoxelGrid world;        ///< occupancy in the world frame: the worlds' marginals
  VoxelGrid object;       ///< the same in the object frame

  double inference_s = 0.0;  ///< wall time that it took to make this [s]
};

}  // namespace smore
