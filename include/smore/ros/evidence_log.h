// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "smore/contact/evidence_filter.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// Free poses count in the maps and in the evidence from a tenth of a voxel on.
EvidenceSpacing spacingFor(const Scenario& task);

/// The observations that maps are made of, in their order, so that another process can make the
/// same maps. Samples that repeat the last entry are left out (EvidenceFilter).
class EvidenceLog {
 public:
  explicit EvidenceLog(const EvidenceSpacing& spacing) : filter_(spacing) {}

  /// Appends the observation if it says something new and tells whether it did.
  bool add(const ContactObservation& observation);

  /// Takes back the last entry, which a map could not take.
  void dropLast() { entries_.pop_back(); }

  /// Entries from position `first` on; none where it is beyond the end.
  std::vector<ContactObservation> from(std::uint64_t first) const;

  std::uint64_t size() const { return entries_.size(); }

  /// Another one for each log.
  std::uint64_t epoch() const { return epoch_; }

  /// Makes the epoch the one after `epoch`: this log takes the place of that one.
  void continueAfter(std::uint64_t epoch) { epoch_ = epoch + 1; }

 private:
  EvidenceFilter filter_;
  std::vector<ContactObservation> entries_;
  std::uint64_t epoch_ = 1;
};

}  // namespace smore
