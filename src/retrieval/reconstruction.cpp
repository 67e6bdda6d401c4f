// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/reconstruction.h"

#include <algorithm>
#include <string>

namespace smore {
namespace {

constexpr int kMotionsPerTouch = 10;  // allowed on average, before the scene counts as empty
// Motions in a row that the robot cannot follow: an arm cannot be at most places that are drawn at
// random in space, so that twenty may be chance.
constexpr int kMostRefused = 100;

// Until the touches end, for the reason that it leaves in the outcome.
void touchOn(const ReconstructionParameters& parameters, Robot* robot, TouchPlanner* touches,
             const std::function<void(Phase)>& enter, const std::function<bool()>& should_stop,
             MotionObserver* motions, RetrievalOutcome* outcome) {
  const int max_motions = kMotionsPerTouch * parameters.touches;
  const int most = std::min(parameters.touches, parameters.max_collisions);
  int refused = 0;
  int made = 0;
  while (outcome->collisions < most && made < max_motions) {
    if (should_stop && should_stop()) {
      outcome->reason = "stopped by the user";
      return;
    }
    enter(Phase::kPlanning);
    const Result<Path> path = touches->nextTouch(robot->pose());
    if (!path) {
      outcome->reason = should_stop && should_stop() ? "stopped by the user" : path.reason();
      return;
    }
    if (path->empty()) {
      outcome->success = true;
      outcome->reason = "no touch is left that is worth making";
      return;
    }
    enter(Phase::kMoving);
    ++outcome->plans;
    if (motions != nullptr) motions->motionBegins(*path, std::nullopt);
    MotionResult motion = robot->follow(*path);
    if (motions != nullptr) motions->motionEnded(motion, robot->pose());
    outcome->path_length = motion.length;
    // Nothing moved: another touch may be within the robot's reach.
    refused = motion.end == MotionEnd::kUnreachable ? refused + 1 : 0;
    if (refused > 0 && refused < kMostRefused) continue;
    ++made;
    if (motion.end == MotionEnd::kContact) {
      if (motion.set_out) ++outcome->collisions;
      const bool reset = parameters.on_contact == OnContact::kReset;
      enter(reset ? Phase::kResetting : Phase::kRetreating);
      motion = reset ? robot->reset(parameters.start) : robot->retreat(parameters.retreat_distance);
    }
    if (motion.end != MotionEnd::kReached) {
      outcome->reason = motion.reason;
      return;
    }
  }
  outcome->success = outcome->collisions >= parameters.touches;
  if (outcome->success) {
    outcome->reason = "the budget of touches is used up";
  } else if (outcome->collisions >= most) {
    outcome->reason = "reached the limit of " + std::to_string(most) + " collisions";
  } else {
    outcome->reason = std::to_string(max_motions) + " motions found too few touches";
  }
}

}  // namespace

ReconstructionParameters reconstructionParameters(const Scenario& scenario) {
  ReconstructionParameters parameters;
  parameters.start = scenario.start;
  parameters.on_contact = scenario.on_contact;
  parameters.touches = scenario.reconstruct_touches;
  return parameters;
}

RetrievalOutcome reconstruct(const ReconstructionParameters& parameters, Robot* robot,
                             TouchPlanner* touches, const Retrieval::ProgressCallback& on_progress,
                             const std::function<bool()>& should_stop, MotionObserver* motions) {
  RetrievalOutcome outcome;
  const auto enter = [&](Phase phase) {
    if (on_progress) on_progress({phase, outcome.collisions, outcome.plans, 0.0});
  };
  touchOn(parameters, robot, touches, enter, should_stop, motions, &outcome);
  enter(Phase::kFinished);
  return outcome;
}

}  // namespace smore
