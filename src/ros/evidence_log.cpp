// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/evidence_log.h"

namespace smore {

bool EvidenceLog::add(const ContactObservation& observation) {
  if (!isNew(observation)) return false;
  entries_.push_back(observation);
  return true;
}

std::vector<ContactObservation> EvidenceLog::from(std::uint64_t first) const {
  if (first >= entries_.size()) return {};
  return {entries_.begin() + static_cast<std::ptrdiff_t>(first), entries_.end()};
}

void EvidenceLog::restart() {
  entries_.clear();
  ++epoch_;
}

bool EvidenceLog::isNew(const ContactObservation& observation) const {
  if (observation.line) return true;
  if (observation.state == ContactState::kUnsure) return false;
  if (entries_.empty()) return true;
  const ContactObservation& last = entries_.back();
  if (observation.contact_id != last.contact_id || observation.state != last.state) return true;
  if (observation.state == ContactState::kContact) return false;
  return distanceBetween(observation.T_world_object, last.T_world_object) >= spacing_.distance ||
         angleBetween(observation.T_world_object, last.T_world_object) >= spacing_.angle;
}

}  // namespace smore
