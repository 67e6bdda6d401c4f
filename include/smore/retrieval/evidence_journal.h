// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "smore/retrieval/evidence_recorder.h"

namespace smore {

struct OpenEvidence;

/// What a running system has observed, in files of evidence (docs/evidence.md): `1.evidence`,
/// `2.evidence` and so on below one directory, a new one for each time that it begins anew. A file
/// never needs an earlier one, and is never changed but by appending. After a crash the newest one
/// holds all that had been observed, but for a record in the middle of which the crash came.
class EvidenceJournal {
 public:
  /// `directory` is made where it is missing. std::runtime_error where that is not possible.
  EvidenceJournal(const std::string& directory, EvidenceSource source);
  ~EvidenceJournal();

  /// Begins a new file with what is known beforehand from now on, and these observations. It takes
  /// its name only once they are in it, so that a crash meanwhile leaves the file before it the
  /// newest. std::runtime_error where it cannot be written.
  void begin(const Priors& priors, const std::vector<ContactObservation>& observations);

  /// Appends to the file that was begun last; one must have been begun. std::runtime_error where it
  /// cannot be written.
  void observe(const ContactObservation& observation);

  /// The file that a journal in `directory` began last; nothing where there is none.
  static std::optional<std::string> newest(const std::string& directory);

 private:
  std::string directory_;
  EvidenceSource source_;
  std::unique_ptr<OpenEvidence> file_;  ///< that was begun last
};

/// Writes evidence of these observations as a whole: `file` is there complete, or as it was before.
/// std::runtime_error where it cannot be written.
void writeEvidence(const std::string& file, const EvidenceSource& source,
                   const std::vector<ContactObservation>& observations);

}  // namespace smore
