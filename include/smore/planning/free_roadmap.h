// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/common/geometry.h"
#include "smore/mapping/free_cells.h"
#include "smore/scenario/motion_space.h"

namespace smore {

/// The pieces of the tracks that lie in the workspace (MotionSpace::isNearWorkspace): the object
/// may have been led out of it, or be told of another one.
std::vector<Path> tracksWithin(const MotionSpace& space, const std::vector<Path>& tracks);

/// Where the object can go without risk: poses that were free, joined along the motions that went
/// through them and where one motion went through a pose of another, or between two of its own.
class FreeRoadmap {
 public:
  /// `tracks`: motions that were free, as freeTracks gives them for `unit` [m]; they are joined
  /// where one passes a pose of another within a cell's size. `from` (T_world_object), where the
  /// object has come on one of them, is joined to all poses that may stand for it in its track.
  FreeRoadmap(const std::vector<Path>& tracks, const Pose& from, const FreeSpaceParameters& cell,
              double unit);

  /// Poses that can be reached from `from`, itself first.
  const Path& reachable() const { return reachable_; }

  /// The shortest way (metres plus radians) from `from` to a reachable pose, both included.
  Path routeTo(int reachable) const;

 private:
  Path reachable_;
  std::vector<int> previous_;  ///< index in reachable_ of the pose before; -1 for the first
};

}  // namespace smore
