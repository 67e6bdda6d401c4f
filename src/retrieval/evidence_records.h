// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/json_fields.h"
#include "smore/retrieval/evidence.h"

namespace smore {

/// Format of the files of evidence (docs/evidence.md). The version rises when an older program
/// could no longer make the same maps of a file.
constexpr char kEvidenceFormat[] = "smore evidence";
constexpr int kEvidenceVersion = 2;

/// What a file begins with: header, task, method and what is known beforehand.
std::vector<Json> sourceRecords(const EvidenceSource& source);
Json observationRecord(const ContactObservation& observation);
Json motionRecord(const Path& path, const std::optional<double>& risk);
Json motionEndRecord(const MotionResult& result, const Pose& T_world_object);
Json outcomeRecord(const RecordedOutcome& outcome);

/// The same, read. InputError for missing or impossible values.
ContactObservation readObservation(const JsonFields& record);
RecordedMotion readMotion(const JsonFields& record);
void readMotionEnd(const JsonFields& record, RecordedMotion* motion);
RecordedOutcome readOutcome(const JsonFields& record);

}  // namespace smore
