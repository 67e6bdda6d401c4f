// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "smore/mapping/joint_belief.h"
#include "smore/retrieval/evidence.h"

namespace smore {

/// The belief of the method smore as scores see it: all that is asked of it is asked here.
class ScoredBelief {
 public:
  ScoredBelief(const Scenario& task, const MethodParameters& parameters, std::uint64_t seed,
               const Priors& priors);

  void observe(const ContactObservation& observation) { belief_->observe(observation); }

  /// Draws its worlds from the same evidence with other random numbers.
  void drawAnew(std::uint64_t seed) { belief_->drawAnew(seed); }

  std::size_t contactCount() const { return belief_->contactCount(); }
  int worldCount() const { return kHypotheses; }

  /// Probability that a motion ends at a contact, as a plan of it would say.
  double riskOf(const Path& path) const;

  /// Share of the worlds in which it touches.
  double touchingShare(const Path& path) const;

  /// Probability that none of the legs up to the i-th touches, for each leg of a motion: not
  /// rising, the last one about 1 - riskOf the whole, whose poses are checked at other places. The
  /// half world with which Jeffreys' prior makes no share 0 is spread evenly over the legs.
  std::vector<double> survival(const std::vector<Path>& legs) const;

  /// Where a contact was in each of the worlds, in the object frame [m]; nothing: a false contact
  /// there. Empty for one that takes no part in the inference.
  std::vector<std::optional<Vec3>> placesOf(const ContactObservation& contact) const;

  const VoxelGrid& world() const { return belief_->world(); }
  const VoxelGrid& object() const { return belief_->object(); }

 private:
  Method method_;
  JointBelief* belief_;  ///< of method_
};

}  // namespace smore
