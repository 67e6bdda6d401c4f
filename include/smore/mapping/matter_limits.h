// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/believed_prior.h"
#include "smore/mapping/forbidden_matter.h"
#include "smore/mapping/surface_patch.h"

namespace smore {

/// Side of the cells to which places of touched matter are told apart [m]: fine against its balls.
float matterCell(const FeatureParameters& feature);

/// Where one side, the object or the world, cannot go on: beyond the reach of what is held, where
/// it would have overlapped the other side at a pose that was free, and where it is known
/// beforehand what there is.
class MatterLimits {
 public:
  enum class Known {
    kIsNotTouched,  ///< what is known beforehand, matter or nothing, is not claimed once more
    kMatterGoesOn,  ///< known matter is matter
  };

  /// `other`: centres of the balls of the other side's touched matter. Nothing that is handed over
  /// has to live on.
  MatterLimits(MapSide side, const std::vector<MaskedPoint>& other,
               const FreeSpaceEvidence& evidence, const BelievedPrior& prior,
               const FeatureParameters& feature, bool planar);

  /// Those of the asked hypotheses in which no matter of that side may be centred at a point.
  HypothesisMask forbiddenAt(const Eigen::Vector3f& point, HypothesisMask asked, Known known) const;
  /// The same for one hypothesis; while this lives, where it stands.
  MatterAllowed allowedFor(int hypothesis, Known known) const;

 private:
  MapSide side_;
  float reach_;
  BelievedPrior prior_;
  std::vector<ForbiddenMatter> forbidden_;
};

}  // namespace smore
