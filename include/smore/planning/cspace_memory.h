// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/contact/contact_observation.h"
#include "smore/contact/first_of_contact.h"
#include "smore/planning/pose_index.h"

namespace smore {

struct CspaceMemoryParameters {
  double radius =
      0.03;  ///< poses nearer to a contact pose are invalid [m + rad], positive (paper, IV)
};

/// The paper's C-space baseline: remembers the pose of each contact and takes poses near one for
/// invalid. The distance of two poses is that of their origins [m] plus the angle between them
/// [rad].
///
/// The paper does not say what happens when a contact pose lies nearer than the radius to the pose
/// from which is planned; taken literally, no plan could ever start there again. Yet the object
/// stands there free, so that the ball around such a contact is too large: here it reaches only as
/// far as the start (see `isValid`).
class CspaceMemory : public ContactObserver {
 public:
  /// std::invalid_argument for a radius that is not positive.
  explicit CspaceMemory(const CspaceMemoryParameters& parameters = {});

  /// Remembers the pose of the first observation in contact of each contact_id; everything else is
  /// ignored, so that rates do not matter.
  void observe(const ContactObservation& observation) override;

  /// Whether no remembered pose c is nearer to `pose` than min(radius, distance of c to
  /// `known_free`).
  bool isValid(const Pose& pose, const Pose& known_free) const;

  const std::vector<Pose>& contactPoses() const { return contacts_.poses(); }
  double radius() const { return parameters_.radius; }

 private:
  CspaceMemoryParameters parameters_;
  PoseIndex contacts_;
  FirstOfContact first_;
};

}  // namespace smore
