// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/grid_collision_checker.h"

namespace smore {

GridCollisionChecker::GridCollisionChecker(const OccupiedVoxels& object,
                                           const OccupiedVoxels& world)
    : overlap_(object, world) {}

bool GridCollisionChecker::inCollision(const Pose& T_world_object) const {
  return clearance(T_world_object, 0.0) < 0.0;
}

double GridCollisionChecker::clearance(const Pose& T_world_object, double enough) const {
  return overlap_.clearance(T_world_object, enough);
}

}  // namespace smore
