// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "smore/contact/contact_observation.h"
#include "smore/retrieval/method.h"
#include "smore/ros/pose_knowledge.h"

namespace smore {

/// A part of a mapping's evidence log, as it came over the wire.
struct EvidencePart {
  std::uint64_t epoch = 0;
  Priors priors;  ///< what is known beforehand, where the epoch is another than the replica's
  std::uint64_t first = 0;
  std::vector<ContactObservation> observations;
  std::uint64_t changes = 0;  ///< of the mapping's maps since its log began, with this part
};

/// The same belief as in a mapping node, made from the same evidence, with a planner on it.
class MethodReplica {
 public:
  /// `parameters`: of the method; those of the belief must be the mapping's.
  MethodReplica(MethodKind kind, const Scenario& scenario, std::uint64_t seed,
                const MethodParameters& parameters = {});

  /// What to ask the mapping for.
  std::uint64_t epoch() const { return epoch_; }
  std::uint64_t size() const { return size_; }

  /// Takes a part that follows what is here; one of another epoch starts anew. False, and all is
  /// forgotten, if the part does not fit or the maps do not change as often as the mapping's
  /// (where the method learns maps at all). InputError for knowledge that the method cannot use.
  bool extend(const EvidencePart& part);

  /// `relaxed`: as Planner::planRelaxed. Plans carry their trees. A failure, with the reason, where
  /// the goal is not in the space of motions.
  Result<Plan> plan(const Pose& start, const Pose& goal, bool relaxed = false,
                    std::vector<Pose> refused = {});

  /// As TouchPlanner::nextTouch.
  Result<Path> nextTouch(const Pose& from) { return method_.touches->nextTouch(from); }

  /// What follows from what is here now; it stays as it is while the replica learns on. The start
  /// of the scenario counts as a pose where the object stands free.
  PoseKnowledge knowledge() const;

  /// Probability that the motion has touched when each pose of `path` is reached; zeros for methods
  /// without risk.
  std::vector<double> risksAlong(const Path& path) const;

 private:
  void restart(std::uint64_t epoch, const Priors& priors);
  std::function<double(const Pose&)> riskOfPoses() const;
  /// Whether it remembers something else than maps, which have nothing to agree with.
  bool learnsNoMaps() const { return method_.memory != nullptr; }

  MethodKind kind_;
  Scenario scenario_;
  std::uint64_t seed_;
  MethodParameters parameters_;
  Method method_;
  std::uint64_t epoch_ = 0;
  std::uint64_t size_ = 0;
  std::uint64_t first_revision_ = 0;  ///< of the maps before any evidence
};

}  // namespace smore
