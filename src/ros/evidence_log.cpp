// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/evidence_log.h"

namespace smore {

EvidenceSpacing spacingFor(const Scenario& task) {
  constexpr double kShare = 0.1;
  EvidenceSpacing spacing;
  spacing.distance = kShare * task.voxel_size;
  if (task.motion == Motion::kPlanar) spacing.T_world_plane = task.motionSpace().T_world_plane;
  return spacing;
}

bool EvidenceLog::add(const ContactObservation& observation) {
  if (!filter_.keeps(observation)) return false;
  entries_.push_back(observation);
  return true;
}

std::vector<ContactObservation> EvidenceLog::from(std::uint64_t first) const {
  if (first >= entries_.size()) return {};
  return {entries_.begin() + static_cast<std::ptrdiff_t>(first), entries_.end()};
}

}  // namespace smore
