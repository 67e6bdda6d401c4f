// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// mapping: what is believed of matter, in the world and in the object: the twin maps and the
// beliefs behind them.

#include <cstdint>
#include <optional>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_cells.h"
#include "smore/mapping/joint_distribution.h"
#include "smore/mapping/worlds_at_unit.h"

namespace smore {

struct JointBeliefParameters {
  double voxel_size = 0.03;  ///< of the published maps [m], positive
  /// The plane of planar motion (its x-y plane), in which every body counts as a prism; nothing for
  /// motion in space.
  std::optional<Pose> T_world_plane;
  std::uint64_t seed = 1;
  /// Where there are more contacts, a tenth of them is merged: those that the others say as well in
  /// all worlds are left out of the inference. At least 10.
  int most_contacts = 100;
  /// The unit of length [m] (unitOfLength), where it is known; 0: it is inferred.
  double unit = 0.0;
  /// What is assumed of matter and how finely it is told apart. Lengths in units of length.
  FeatureParameters feature;
  FreeSpaceParameters free_space;
  DistributionParameters distribution;
  ExtentParameters extent;
  PriorParameters prior;
};

/// The parameters with all that is in units of length in metres, if the unit of matter is `unit`
/// [m] and that of the reach of what is held is `held` [m].
JointBeliefParameters inMetres(JointBeliefParameters parameters, double unit, double held);

}  // namespace smore
