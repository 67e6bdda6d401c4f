// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "smore/common/json_lines.h"
#include "smore/retrieval/evidence_recorder.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

/// Records a simulated trial: what the method is given and, apart from it, the truth.
class TrialRecording : public MotionObserver {
 public:
  /// `perturbed` is the scene as simulated; `robot` must outlive this. std::runtime_error, here and
  /// later, where the file cannot be written.
  TrialRecording(const std::string& file, const EvidenceSource& source, const Scenario& perturbed,
                 const SimulatedRobot* robot);

  /// The observation of the simulator's last step.
  void observe(const ContactObservation& observation);

  void motionBegins(const Path& path, const std::optional<double>& risk) override;
  void motionEnded(const MotionResult& result, const Pose& T_world_object) override;
  void finish(const RetrievalOutcome& outcome);

 private:
  JsonLinesWriter file_;
  EvidenceRecorder evidence_;
  const SimulatedRobot* robot_;
};

/// Where the trial of a seed is recorded.
std::string evidenceFile(const std::string& directory, std::uint64_t seed);

}  // namespace smore
