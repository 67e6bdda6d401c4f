// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/belief_parameters.h"

namespace smore {

JointBeliefParameters inMetres(JointBeliefParameters parameters, double unit, double held) {
  for (double* length :
       {&parameters.feature.radius, &parameters.feature.tolerance, &parameters.feature.decay,
        &parameters.free_space.position_cell, &parameters.distribution.object.scale,
        &parameters.distribution.world.scale, &parameters.extent.shortest,
        &parameters.extent.object_longest, &parameters.extent.world_longest,
        &parameters.prior.scale}) {
    *length *= unit;
  }
  parameters.feature.reach *= held;
  return parameters;
}

}  // namespace smore
