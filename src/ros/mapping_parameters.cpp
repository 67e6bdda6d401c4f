// SPDX-License-Identifier: BSD-3-Clause
#include "mapping_parameters.h"

#include <ctime>
#include <limits>

#include "scenario_priors.h"
#include "smore/common/result.h"
#include "smore/ros/belief_files.h"

namespace smore {
namespace {

// For a node that was started by itself: no other start has the same.
std::string nameOfNow() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  return {text, std::strftime(text, sizeof(text), "%Y-%m-%d_%H-%M-%S", &local)};
}

}  // namespace

MappingParameters readMappingParameters(ParameterReader* reader) {
  MappingParameters parameters;
  parameters.frames = readFrameNames(reader);
  parameters.method = readMethod(reader);
  parameters.method_parameters = readMethodChanges(reader, parameters.method);
  reader->integer("seed", &parameters.seed, 0, std::numeric_limits<int>::max());
  reader->number("publish_period", &parameters.publish_period, {0.01, 60.0});
  reader->number("display_min_probability", &parameters.display_min_probability,
                 kDisplayProbabilities);
  reader->number("line_half_length", &parameters.line_half_length, kLineHalfLengths);
  if (reader->has("journal")) reader->text("journal", &parameters.journal);
  parameters.launch = nameOfNow();
  if (reader->has("launch")) reader->text("launch", &parameters.launch);
  if (reader->has("resume")) reader->text("resume", &parameters.resume);
  reader->text("beliefs", &parameters.beliefs);
  return parameters;
}

EvidenceSource sourceOf(const MappingParameters& parameters, const Scenario& scenario) {
  EvidenceSource source;
  source.task = scenario;
  source.method = parameters.method;
  source.parameters = parameters.method_parameters;
  source.seed = static_cast<std::uint64_t>(parameters.seed);
  source.priors = priorsOf(scenario, source.seed);
  return source;
}

std::optional<std::string> journalOf(const MappingParameters& parameters) {
  if (parameters.journal.empty()) return std::nullopt;
  return belowRosHome(parameters.journal) + "/" + parameters.launch;
}

std::optional<std::string> earlierEvidence(const MappingParameters& parameters) {
  const auto own_journal = journalOf(parameters);
  if (own_journal) {
    if (auto own = EvidenceJournal::newest(*own_journal)) return own;
  }
  if (parameters.resume.empty()) return std::nullopt;
  const std::string directory = belowRosHome(parameters.resume);
  if (auto other = EvidenceJournal::newest(directory)) return other;
  throw InputError("resume: '" + directory +
                   "' holds no journal; give the directory of a launch, with files such as "
                   "1.evidence in it");
}

}  // namespace smore
