// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/evidence_recorder.h"

#include <nlohmann/json.hpp>

#include "evidence_records.h"
#include "prior_record.h"
#include "task_record.h"

namespace smore {

EvidenceRecorder::EvidenceRecorder(JsonLinesWriter* file, const EvidenceSource& source)
    : file_(file), filter_(lossless()) {
  for (const Json& record : sourceRecords(source)) file_->append(record);
}

bool EvidenceRecorder::observe(const ContactObservation& observation) {
  if (!filter_.keeps(observation)) return false;
  file_->append(observationRecord(observation));
  return true;
}

void EvidenceRecorder::motionBegins(const Path& path, const std::optional<double>& risk) {
  file_->append(motionRecord(path, risk));
}

void EvidenceRecorder::motionEnded(const MotionResult& result, const Pose& T_world_object) {
  file_->append(motionEndRecord(result, T_world_object));
}

void EvidenceRecorder::finish(const RecordedOutcome& outcome) {
  file_->append(outcomeRecord(outcome));
}

}  // namespace smore
