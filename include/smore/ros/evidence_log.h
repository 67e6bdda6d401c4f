// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "smore/contact/contact_observation.h"

namespace smore {

/// How far a free pose must be from the last one in the log to say something new.
struct EvidenceSpacing {
  double distance = 0.003;  ///< [m], positive
  double angle = 0.01;      ///< [rad], positive
};

/// The observations that maps are made of, in their order, so that another process can make the
/// same maps. Samples that repeat the last entry are left out: the log grows with the way travelled
/// and with the contacts, not with time.
class EvidenceLog {
 public:
  explicit EvidenceLog(const EvidenceSpacing& spacing) : spacing_(spacing) {}

  /// Appends the observation if it says something new (a line, a new contact, a change of state, a
  /// free pose away from the last) and tells whether it did. Unsure samples say nothing.
  bool add(const ContactObservation& observation);

  /// Entries from position `first` on; none where it is beyond the end.
  std::vector<ContactObservation> from(std::uint64_t first) const;

  std::uint64_t size() const { return entries_.size(); }

  /// Rises when the log begins anew; starts at 1.
  std::uint64_t epoch() const { return epoch_; }
  void restart();

 private:
  bool isNew(const ContactObservation& observation) const;

  EvidenceSpacing spacing_;
  std::vector<ContactObservation> entries_;
  std::uint64_t epoch_ = 1;
};

}  // namespace smore
