// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/retrieval/touch_planner.h"

namespace smore {

/// Motions that somebody has written down, one after the other, whatever is learnt on the way.
class WrittenTouches : public TouchPlanner {
 public:
  /// Each motion goes through its poses (T_world_object, at least one) from wherever it begins.
  explicit WrittenTouches(std::vector<Path> motions);

  Result<Path> nextTouch(const Pose& from) override;

 private:
  std::vector<Path> motions_;
  std::size_t next_ = 0;
};

/// The motions of a file (docs/touches.md): `motions`, a list of mappings with `poses`, each with a
/// `position` [m] and, where given, `rpy` [rad]. InputError with all problems of the file, poses
/// outside of `space` among them.
std::vector<Path> loadMotions(const std::string& file, const MotionSpace& space);

}  // namespace smore
