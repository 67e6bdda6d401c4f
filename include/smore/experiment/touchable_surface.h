// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "smore/mapping/voxel_grid.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// Points of the true surfaces, 1 cm apart, that some motion can bring into contact.
struct TouchableSurface {
  std::vector<Vec3> object;  ///< in the object frame [m]
  std::vector<Vec3> world;   ///< in the world frame [m]
};

/// What can be touched in a scene of planar motion: the outlines in the plane of motion are
/// sampled, and from the start all poses are visited that can be reached without contact on a
/// lattice of 2 cm and 0.1 rad; a point is touchable if at one of them it is within 2 cm of the
/// other body. Nothing for motion in space. Takes some seconds of processor time.
TouchableSurface touchableSurface(const Scenario& scenario);

/// Share of the points within one voxel size of the centre of an occupied voxel (P >= 0.5); nothing
/// where there are no points. Points and grid are in one frame.
std::optional<double> surfaceRecall(const VoxelGrid& grid, const std::vector<Vec3>& points);

}  // namespace smore
