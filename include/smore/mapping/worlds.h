// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "smore/mapping/free_cells.h"
#include "smore/mapping/joint_distribution.h"
#include "smore/mapping/map_frame.h"
#include "smore/mapping/sampled_worlds.h"
#include "smore/mapping/voxel_grid.h"

namespace smore {

/// For each contact, by its id, and in each world where it was touched [object frame]; nothing
/// where the world holds the contact to be false.
using TouchedPlaces = std::map<std::uint64_t, std::vector<std::optional<Vec3>>>;

/// All that a joint belief says at one moment. A value: it stays as it is while the belief learns
/// on, and threads may share it.
struct Worlds {
  MapFrame frame;             ///< of the sampled worlds and the free cells
  double unit = 0.0;          ///< of length, of matter [m]: the worlds' geometric mean
  double held = 0.0;          ///< the same of the reach of what is held: no smaller
  FeatureParameters feature;  ///< what a touch was assumed to be in most worlds [m]
  FreeCells free;             ///< where the object was free, in cells of the likeliest unit
  /// Motions that were free, in the order in which they were made [T_world_object].
  std::vector<Path> tracks;
  std::size_t contacts = 0;  ///< observed so far, those that were merged included

  SampledWorlds sampled;
  TouchedPlaces touched;  ///< of the contacts that take part

  double inference_s = 0.0;  ///< wall time that it took to make this [s]
};

}  // namespace smore
