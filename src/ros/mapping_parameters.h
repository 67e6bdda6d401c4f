// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "smore/common/parameters.h"
#include "smore/retrieval/evidence_journal.h"
#include "smore/ros/parameter_source.h"

namespace smore {

constexpr Range kDisplayProbabilities{1e-6, 1.0};
constexpr Range kLineHalfLengths{0.01, 100.0};  // [m]

/// Parameters of the mapping node; config/mapping.yaml explains each.
struct MappingParameters {
  FrameNames frames;
  MethodKind method = MethodKind::kSmore;
  MethodParameters method_parameters;  ///< of the method
  int seed = 1;
  double publish_period = 0.5;            ///< wall time [s]
  double display_min_probability = 0.3;   ///< of the cells shown, in (0, 1]
  double line_half_length = 1.0;          ///< of the lines shown [m]
  std::string journal;                    ///< directory of journals; empty: none is written
  std::string launch = "mapping";         ///< name of this launch's journal, below it
  std::string resume;                     ///< directory of the journal to go on from; empty: none
  std::string beliefs = "smore/beliefs";  ///< folder of what is saved and loaded
};

/// Errors are noted in `reader`.
MappingParameters readMappingParameters(ParameterReader* reader);

/// What the maps follow from, besides the observations.
EvidenceSource sourceOf(const MappingParameters& parameters, const Scenario& scenario);

/// Directory of this launch's journal; nothing where none is written.
std::optional<std::string> journalOf(const MappingParameters& parameters);

/// The file to go on from: of this node before it was started again in the same launch, else of the
/// launch that `resume` names; nothing where neither is. InputError where `resume` names none.
std::optional<std::string> earlierEvidence(const MappingParameters& parameters);

}  // namespace smore
