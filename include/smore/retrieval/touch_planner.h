// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

#include "smore/common/geometry.h"
#include "smore/common/result.h"
#include "smore/scenario/motion_space.h"

namespace smore {

/// Chooses motions that are meant to touch.
class TouchPlanner {
 public:
  virtual ~TouchPlanner() = default;

  /// The next motion, from `from` (T_world_object); empty where none is left that is worth making.
  /// The reason where none could be chosen.
  virtual Result<Path> nextTouch(const Pose& from) = 0;
};

/// Straight motions to poses drawn uniformly from the motion space: poking about without a plan.
class RandomTouches : public TouchPlanner {
 public:
  RandomTouches(const MotionSpace& space, std::uint64_t seed);

  Result<Path> nextTouch(const Pose& from) override;

 private:
  Pose draw();

  MotionSpace space_;
  std::mt19937_64 random_;
};

}  // namespace smore
