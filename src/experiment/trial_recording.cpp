// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/trial_recording.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "smore/experiment/trial_truth.h"

namespace smore {
namespace {

// Another run that still writes a file of this name keeps the one that it has: the records of two
// are never mixed.
std::string freed(const std::string& file) {
  std::error_code none;
  std::filesystem::remove(file, none);  // what remains shows when it is opened
  return file;
}

}  // namespace

TrialRecording::TrialRecording(const std::string& file, const EvidenceSource& source,
                               const Scenario& perturbed, const SimulatedRobot* robot)
    : file_(freed(file)), evidence_(&file_, source), robot_(robot) {
  file_.append(solidsRecord(perturbed));
}

void TrialRecording::observe(const ContactObservation& observation) {
  const bool recorded = evidence_.observe(observation);
  if (!recorded || observation.state != ContactState::kContact) return;
  // Again with the line: what touches when the contact is noticed need not be what it settles on.
  file_.append(contactTruthRecord(observation.contact_id, robot_->contacts()));
}

void TrialRecording::motionBegins(const Path& path, const std::optional<double>& risk) {
  evidence_.motionBegins(path, risk);
}

void TrialRecording::motionEnded(const MotionResult& result, const Pose& T_world_object) {
  evidence_.motionEnded(result, T_world_object);
}

void TrialRecording::finish(const RetrievalOutcome& outcome) {
  evidence_.finish({outcome.success, outcome.reason, outcome.collisions});
}

std::string evidenceFile(const std::string& directory, std::uint64_t seed) {
  return directory + "/seed_" + std::to_string(seed) + ".evidence";
}

}  // namespace smore
