// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/contact/contact_observation.h"

namespace smore {

/// How far a free pose must be from the last one that was kept to say something new, and in which
/// plane it must lie.
struct EvidenceSpacing {
  double distance = 0.003;  ///< [m]; not negative
  double angle = 0.01;      ///< [rad]; not negative
  /// Of planar motion: what is observed elsewhere (isNearPlane), as where somebody has lifted the
  /// object, says nothing about its plane.
  std::optional<Pose> T_world_plane = std::nullopt;
};

/// With this, only that is left out which changes nothing that learns from observations (TwinMap,
/// CspaceMemory): unsure samples without a line, a contact that goes on, a free sample at the very
/// pose of the one before.
inline EvidenceSpacing lossless() { return {0.0, 0.0, std::nullopt}; }

/// Keeps the observations that say something new: a line, a new contact, a change of state, a free
/// pose away from the last. So what is kept grows with the way travelled and with the contacts, not
/// with time.
class EvidenceFilter {
 public:
  explicit EvidenceFilter(const EvidenceSpacing& spacing) : spacing_(spacing) {}

  /// Whether the observation is to be kept; the next ones are then measured against it.
  bool keeps(const ContactObservation& observation);

 private:
  bool isElsewhere(const Pose& T_world_object) const;
  bool isNew(const ContactObservation& observation) const;
  bool isAway(const Pose& T_world_object) const;

  EvidenceSpacing spacing_;
  std::optional<ContactObservation> last_;
};

}  // namespace smore
