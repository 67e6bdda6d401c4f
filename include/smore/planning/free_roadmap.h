// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/common/geometry.h"
#include "smore/mapping/free_cells.h"

namespace smore {

/// Where the object can go without risk: poses that were free, joined along the motions that went
/// through them and where two motions went through one pose.
class FreeRoadmap {
 public:
  /// `tracks`: motions that were free. `from` (T_world_object) is one more pose, joined to the
  /// poses of the tracks within a cell's size, as they are to one another.
  FreeRoadmap(const std::vector<Path>& tracks, const Pose& from, const FreeSpaceParameters& cell);

  /// Poses that can be reached from `from`, itself first.
  const Path& reachable() const { return reachable_; }

  /// The shortest way (metres plus radians) from `from` to a reachable pose, both included.
  Path routeTo(int reachable) const;

 private:
  Path reachable_;
  std::vector<int> previous_;  ///< index in reachable_ of the pose before; -1 for the first
};

}  // namespace smore
