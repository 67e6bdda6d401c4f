// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// planning: motions of the object, and their risk, by what is believed of matter.

#include <cstdint>
#include <optional>
#include <vector>

#include "smore/contact/contact_observation.h"
#include "smore/contact/first_of_contact.h"
#include "smore/planning/movement_belief.h"
#include "smore/planning/movement_trail.h"
#include "smore/planning/pose_index.h"

namespace smore {

/// Our choices, the same for all scenes (docs/rivals.md).
struct BlockedMovementsParameters {
  double width = 0.05;  ///< standard deviation of the kernels [m + rad], positive
  double prior = 0.01;  ///< probability that an untried configuration is blocked, in (0, 1)
  double weight = 0.1;  ///< how many observations the prior counts, positive
};

/// A probability map over configurations, learnt from movements that succeeded and movements that
/// were blocked, with no idea of shapes (after Pajarinen, Arenz, Peters and Neumann, "Probabilistic
/// approach to physical object disentangling", IEEE RA-L 2020; docs/rivals.md says what is theirs).
///
/// With the kernel k(d) = exp(-d^2 / (2 width^2)), d the distance of the origins [m] plus the angle
/// between them [rad], 0 beyond three widths, a configuration q is blocked with the probability
///
///   P(q) = (weight * prior + max_b n_b k(q, b)) / (weight + max_b n_b k(q, b) + max_f k(q, f))
///
/// over the configurations b that were blocked, each n_b times, and the free poses f: the mean of a
/// Beta distribution with kernels as fractions of observations. The strongest counts alone, since
/// what happens at neighbouring configurations is mostly one obstacle's doing, or one gap's.
class BlockedMovements : public ContactObserver, public MovementBelief {
 public:
  /// std::invalid_argument for parameters out of their ranges.
  explicit BlockedMovements(const BlockedMovementsParameters& parameters = {});

  /// Counts a free pose once for each half of a width, so that rates and returns do not matter, and
  /// at the first observation of each contact the configuration that the movement would have come
  /// to a width further on, or once more the one that was blocked within half a width of it.
  void observe(const ContactObservation& observation) override;

  /// Probability that an attempt to move to a neighbouring configuration is blocked, in (0, 1).
  double blocked(const Pose& T_world_object) const;

  /// exp of the integral of log(1 - blocked(q)) along the path, whose length counts in widths.
  double success(const Path& path) const override;

 private:
  std::optional<std::uint32_t> counted(const PoseIndex& index, const Pose& T_world_object) const;
  void countBlocked(const Pose& T_world_object);
  double kernel(double distance) const;

  BlockedMovementsParameters parameters_;
  PoseIndex free_;
  PoseIndex blocked_;
  std::vector<double> times_blocked_;  ///< n_b of blocked_.poses()
  MovementTrail trail_;
  FirstOfContact contacts_;
};

}  // namespace smore
