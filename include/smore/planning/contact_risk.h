// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"
#include "smore/mapping/joint_belief.h"

namespace smore {

/// Probability of contact under a joint belief: the share of its sampled worlds in which something
/// touches. Along a path a world counts once, however often the path touches in it, so that what
/// one unknown decides is not counted as many risks.
class ContactRisk {
 public:
  /// A view of the belief as it is now; valid until the belief takes another observation.
  explicit ContactRisk(const JointBelief& belief);

  /// Worlds in which the object touches at a pose [T_world_object].
  HypothesisMask touching(const Pose& T_world_object) const;
  /// Worlds in which it touches somewhere on the segments of `path`.
  HypothesisMask touchingAlong(const Path& path) const;

  double atPose(const Pose& T_world_object) const { return shareOf(touching(T_world_object)); }
  double along(const Path& path) const { return shareOf(touchingAlong(path)); }

  /// Probability that a motion along `path` ends at a contact: with what is known, or with matter
  /// that nothing has touched yet. The latter comes at a rate for each cell of poses
  /// (FreeSpaceParameters) that is entered for the first time; the rate is estimated from the
  /// contacts and the free cells so far, with one contact in kPriorLength of motion to begin with
  /// (docs/planning.md).
  double ofMotion(const Path& path) const;

  /// Mean length of a motion until something is touched, before anything is known: about as far as
  /// a hand moves a held thing among others [m].
  static constexpr double kPriorLength = 1.0;

  const SampledWorlds& worlds() const { return *worlds_; }

 private:
  const JointBelief* belief_;
  const SampledWorlds* worlds_;
  double check_distance_;
  double check_angle_;
};

}  // namespace smore
