// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"
#include "smore/mapping/joint_belief.h"

namespace smore {

/// Probability of contact under a joint belief: the weight of its sampled worlds in which something
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

  double atPose(const Pose& T_world_object) const {
    return worlds_->shareOf(touching(T_world_object));
  }
  double along(const Path& path) const { return worlds_->shareOf(touchingAlong(path)); }

  /// Probability that a motion along `path` ends at a contact: with what is known, or with matter
  /// that nothing has touched yet. How far it goes without the latter follows from how far the
  /// object has moved so far, in cells of poses (FreeSpaceParameters), at no scale of its own
  /// (docs/planning.md, where it is compared with motions of the simulator).
  double ofMotion(const Path& path) const;

  /// What the outcome of a motion along `path` will tell about the sampled worlds [nat]: the
  /// entropy of where on it the first contact will be, if anywhere. A contact with matter that
  /// nothing has touched yet may end it too, at any of the places of the object's surface.
  double informationOf(const Path& path) const;

  /// Mean length of a motion that is meant to touch until it does, before anything is known: about
  /// as far as a hand moves a held thing among others [m].
  static constexpr double kPriorLength = 1.0;

  const SampledWorlds& worlds() const { return *worlds_; }

 private:
  /// Contacts with matter that nothing has touched yet, for each cell of poses that is entered for
  /// the first time, in motions that are meant to touch.
  double surpriseRate() const;
  /// Places on a held thing, as large as it may be, that contacts tell apart.
  double patchesOfObject() const;

  const JointBelief* belief_;
  const SampledWorlds* worlds_;
  double check_distance_;
  double check_angle_;
};

}  // namespace smore
