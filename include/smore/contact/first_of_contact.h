// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/contact/contact_observation.h"

namespace smore {

/// Tells the first observation of each contact from those that follow.
class FirstOfContact {
 public:
  /// Takes the observations in their order.
  bool isFirst(const ContactObservation& observation) {
    if (observation.state != ContactState::kContact || last_id_ == observation.contact_id) {
      return false;
    }
    last_id_ = observation.contact_id;
    return true;
  }

 private:
  std::optional<int> last_id_;
};

}  // namespace smore
