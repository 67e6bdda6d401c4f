// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "smore/mapping/believed_prior.h"

namespace smore {

/// How much of the space around the object prior knowledge leaves open: where something that nobody
/// knew of may touch.
class UnknownPlaces {
 public:
  /// Within `reach` of the object frame's origin [m, positive], or as far as known matter of the
  /// object reaches, where that is nearer and free space is known beside it; in `planar` motion in
  /// the plane z = 0. `members`: the worlds that count.
  UnknownPlaces(const BelievedPrior& prior, HypothesisMask members, double reach, bool planar);

  /// The number of these worlds, each counted by the share of the places within reach at which,
  /// with the object at this pose in the map frame, something may touch that it does not hold to be
  /// known beforehand: neither side is known to be free there, nor are both known to be matter. All
  /// of them where nothing is known.
  double worldsAt(const Eigen::Isometry3f& T_map_object) const;

 private:
  struct Piece {
    std::shared_ptr<const KnownMatter> known;
    HypothesisMask worlds;  ///< that hold it to be true
  };
  HypothesisMask unknownAt(const Eigen::Vector3f& on_object, const Eigen::Vector3f& in_map) const;

  HypothesisMask members_;
  std::vector<Piece> pieces_;
  std::vector<Eigen::Vector3f> places_;  ///< in the object frame, evenly within reach
};

}  // namespace smore
