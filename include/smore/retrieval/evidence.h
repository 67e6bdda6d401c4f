// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// retrieval: the loop of plan, motion and contact; the methods put together for it; its evidence,
// recorded and replayed.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "smore/contact/contact_observation.h"
#include "smore/retrieval/method.h"
#include "smore/retrieval/retrieval.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// What learns, and from what task: all that maps follow from, besides the observations.
struct EvidenceSource {
  /// What a method may know of the scenario: no shapes, no perturbation, no bias of the sensor.
  Scenario task;
  MethodKind method = MethodKind::kSmore;
  MethodParameters parameters;  ///< of the method
  std::uint64_t seed = 1;
  Priors priors;  ///< what is known beforehand
};

/// The source as the records that a file of evidence begins with, one a line.
std::string toRecords(const EvidenceSource& source);

/// The same, read. InputError as of readEvidence, with `name` for the file. `parameters`: instead
/// of the recorded ones.
EvidenceSource readEvidenceSource(const std::string& records, const std::string& name,
                                  const std::optional<MethodParameters>& parameters = std::nullopt);

/// A planned motion, and what came of it.
struct RecordedMotion {
  Path path;                            ///< as planned [T_world_object]
  std::optional<double> risk;           ///< that was stated before it, in [0, 1]
  std::size_t observations_before;      ///< observations that had been recorded when it began
  std::optional<MotionEnd> end;         ///< nothing where the file ends before the motion did
  Pose T_world_end = Pose::Identity();  ///< where the object was then
  double length = 0.0;                  ///< executed [m]
};

/// How a trial ended.
struct RecordedOutcome {
  bool success = false;
  std::string reason;
  int collisions = 0;
};

/// Everything that a file of evidence says but the truth (docs/evidence.md).
struct Evidence {
  std::string file;
  std::string program;  ///< version of the program that wrote it
  EvidenceSource source;
  std::vector<ContactObservation> observations;  ///< in their order
  std::vector<RecordedMotion> motions;           ///< in their order
  std::optional<RecordedOutcome> outcome;  ///< nothing for a trial that did not come to an end
  bool whole = true;                       ///< false where the last record was cut
};

/// Reads a file of evidence, up to its last whole record. InputError with file, line and remedy:
/// unreadable, of another kind or of a newer format, damaged, or cut before task and method are
/// whole. `parameters`: instead of the recorded ones, which are then not read.
Evidence readEvidence(const std::string& file,
                      const std::optional<MethodParameters>& parameters = std::nullopt);

/// Hands all observations to what learns and has the maps made. InputError where one lies outside
/// of what voxels of the method's size can hold.
void replay(const Evidence& evidence, Method* method);

}  // namespace smore
