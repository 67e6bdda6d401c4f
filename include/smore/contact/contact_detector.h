// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <utility>

#include "smore/contact/contact_observation.h"

namespace smore {

struct ContactDetectorParameters {
  double contact_force = 5.0;     ///< mean force over the fast window at or above: touching [N]
  double free_force = 0.5;        ///< mean force over the slow window below: nothing touches [N]
  double release_force = 2.5;     ///< a contact lasts until the fast mean falls below [N]
  double dwell = 0.004;           ///< how long the contact force must last; impacts are shorter [s]
  double fast_window = 0.004;     ///< [s]; short: the stop waits for it
  double release_window = 0.004;  ///< [s], at least the fast one; in it contact is found to end
  double slow_window = 0.02;      ///< [s]; long: sensor noise must fall below free_force in it
};

/// Tells contact from free space by the force's magnitude, with hysteresis against noise and a
/// dwell against impact spikes. The mean is taken over force vectors, so that noise cancels.
class ContactDetector {
 public:
  explicit ContactDetector(const ContactDetectorParameters& parameters);

  /// State after a sample of force [N] at `time` [s]; times must rise. `mean_stddev` [N]: how far,
  /// on each axis, the slow mean may be off by the sensor's errors. What these explain is free
  /// space too, up to the release force.
  ContactState process(double time, const Vec3& force, double mean_stddev = 0.0);

  /// Contacts confirmed so far.
  int contactCount() const { return contact_count_; }

  /// Forgets the samples and the state; the count goes on.
  void reset();

 private:
  /// Mean over the samples not older than `window` before the newest.
  Vec3 meanForce(double window) const;
  void updateContact(double time);

  ContactDetectorParameters parameters_;
  std::deque<std::pair<double, Vec3>> samples_;
  bool in_contact_ = false;
  double confirmed_at_ = 0.0;  ///< of the present contact [s]
  double above_since_ = -1.0;  ///< when the contact force was reached; negative: it is not
  int contact_count_ = 0;
};

}  // namespace smore
