// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/json_lines.h"
#include "smore/contact/evidence_filter.h"
#include "smore/retrieval/evidence.h"
#include "smore/retrieval/motion_observer.h"

namespace smore {

/// Writes what a method is given, record by record, so that its maps can be made again bit by bit
/// (readEvidence). A record is safe from a crash of this process once the call returns.
class EvidenceRecorder : public MotionObserver {
 public:
  /// Writes header, task, method and priors to `file`, which is empty and must outlive this.
  EvidenceRecorder(JsonLinesWriter* file, const EvidenceSource& source);

  /// Records an observation, unless it provably changes no map (lossless). Whether it did.
  bool observe(const ContactObservation& observation);

  void motionBegins(const Path& path, const std::optional<double>& risk) override;
  void motionEnded(const MotionResult& result, const Pose& T_world_object) override;

  void finish(const RecordedOutcome& outcome);

 private:
  JsonLinesWriter* file_;
  EvidenceFilter filter_;
};

}  // namespace smore
