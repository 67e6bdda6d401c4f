// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/cspace_memory.h"

#include <stdexcept>

namespace smore {

CspaceMemory::CspaceMemory(const CspaceMemoryParameters& parameters)
    : parameters_(parameters), contacts_(parameters.radius) {
  if (!(parameters.radius > 0.0)) {
    throw std::invalid_argument("the radius of the C-space memory must be positive");
  }
}

void CspaceMemory::observe(const ContactObservation& observation) {
  if (first_.isFirst(observation)) contacts_.add(observation.T_world_object);
}

bool CspaceMemory::isValid(const Pose& pose, const Pose& known_free) const {
  return !contacts_.anyNear(pose, [&](std::uint32_t contact, double distance) {
    return distance < parameters_.radius &&
           distance < gapBetween(known_free, contacts_.poses()[contact]);
  });
}

}  // namespace smore
