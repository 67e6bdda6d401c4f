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

  const SampledWorlds& worlds() const { return *worlds_; }

 private:
  const JointBelief* belief_;
  const SampledWorlds* worlds_;
  double check_distance_;
  double check_angle_;
};

}  // namespace smore
