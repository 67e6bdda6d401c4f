// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/evidence_filter.h"

namespace smore {

bool EvidenceFilter::keeps(const ContactObservation& observation) {
  if (isElsewhere(observation.T_world_object) || !isNew(observation)) return false;
  last_ = observation;
  return true;
}

bool EvidenceFilter::isElsewhere(const Pose& T_world_object) const {
  if (!spacing_.T_world_plane) return false;
  return !isNearPlane(spacing_.T_world_plane->inverse() * T_world_object);
}

bool EvidenceFilter::isNew(const ContactObservation& observation) const {
  if (observation.line) return true;
  if (observation.state == ContactState::kUnsure) return false;
  if (!last_) return true;
  if (observation.contact_id != last_->contact_id || observation.state != last_->state) return true;
  return observation.state == ContactState::kFree && isAway(observation.T_world_object);
}

bool EvidenceFilter::isAway(const Pose& T_world_object) const {
  const Pose& last = last_->T_world_object;
  if (T_world_object.matrix() == last.matrix()) return false;
  return distanceBetween(T_world_object, last) >= spacing_.distance ||
         angleBetween(T_world_object, last) >= spacing_.angle;
}

}  // namespace smore
