// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "smore/common/geometry.h"
#include "smore/mapping/worlds.h"

namespace smore {

/// Probability of contact under a joint belief: the share of its sampled worlds in which something
/// touches. Along a path a world counts once, however often the path touches in it, so that what
/// one unknown decides is not counted as many risks.
class ContactRisk {
 public:
  /// Under what a belief says at one moment (JointBelief::worlds); not null.
  explicit ContactRisk(std::shared_ptr<const Worlds> worlds);

  /// Worlds in which the object touches at a pose [T_world_object].
  HypothesisMask touching(const Pose& T_world_object) const;
  /// Worlds in which it touches somewhere on the segments of `path`.
  HypothesisMask touchingAlong(const Path& path) const;

  double atPose(const Pose& T_world_object) const {
    return SampledWorlds::shareOf(touching(T_world_object));
  }
  double along(const Path& path) const { return SampledWorlds::shareOf(touchingAlong(path)); }

  /// Probability that a motion along `path` ends at a contact: with what is known, or with matter
  /// that nothing has touched yet. How far it goes without the latter follows from how far the
  /// object has moved so far, in cells of poses (FreeSpaceParameters), each as far as something
  /// unknown may touch there, at no scale of its own: docs/planning.md (P1).
  double ofMotion(const Path& path) const;

  /// What the outcome of a motion along `path` will tell about the sampled worlds [nat]: the
  /// entropy of where on it the first contact will be, if anywhere, docs/touches.md (T1). A contact
  /// with matter that nothing has touched yet may end it too, at any of the places of the object's
  /// surface.
  double informationOf(const Path& path) const;

  /// Probability that nothing has ended a motion but matter that is known, once it has entered
  /// `fresh` cells of poses for the first time (FreshCells).
  double noSurpriseIn(double fresh) const;

  const Worlds& worlds() const { return *worlds_; }

 private:
  /// Places on a held thing, as large as it may be, that contacts tell apart.
  double patchesOfObject() const;

  std::shared_ptr<const Worlds> worlds_;
  double check_distance_;
  double check_angle_;
  double known_cells_;
};

}  // namespace smore
