// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace smore {

/// A new contact ends a robot's motion, whatever its commander is doing. A motion that was
/// commanded in contact leads away from it, and may rub on its way.
class ContactReflex {
 public:
  /// A motion is commanded, by what is known now.
  void onMotion() { leaving_ = touching_; }

  /// Whether an observation ends the motion: does it say that something touches, and which contact
  /// it is.
  bool onObservation(bool touching, std::uint32_t contact_id) {
    touching_ = touching;
    const bool fresh = touching_ && contact_id != last_contact_;
    last_contact_ = contact_id;
    return fresh && !leaving_;
  }

 private:
  std::uint32_t last_contact_ = 0;
  bool touching_ = false;  ///< by the newest observation
  bool leaving_ = false;   ///< whether it touched when the present motion was commanded
};

}  // namespace smore
