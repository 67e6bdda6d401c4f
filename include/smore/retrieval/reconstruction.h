// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <random>

#include "smore/common/robot.h"
#include "smore/retrieval/retrieval.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// Chooses motions that are meant to touch.
class TouchPlanner {
 public:
  virtual ~TouchPlanner() = default;

  /// The next motion, from `from` (T_world_object).
  virtual Path nextTouch(const Pose& from) = 0;
};

/// Straight motions to poses drawn uniformly from the motion space: poking about without a plan.
class RandomTouches : public TouchPlanner {
 public:
  RandomTouches(const MotionSpace& space, std::uint64_t seed);

  Path nextTouch(const Pose& from) override;

 private:
  MotionSpace space_;
  std::mt19937_64 random_;
};

struct ReconstructionParameters {
  Pose start = Pose::Identity();  ///< T_world_object
  OnContact on_contact = OnContact::kReset;
  double retreat_distance = 0.05;  ///< [m + rad], positive
  int touches = 300;               ///< budget, at least 1
};

ReconstructionParameters reconstructionParameters(const Scenario& scenario);

/// Touches until the budget is used up; the maps are the result (paper, section III-D). Motions
/// that touch nothing are observations too, but not counted; after ten times the budget of motions
/// it ends all the same. `should_stop` is asked before each motion and may be empty.
RetrievalOutcome reconstruct(const ReconstructionParameters& parameters, Robot* robot,
                             TouchPlanner* touches, const Retrieval::ProgressCallback& on_progress,
                             const std::function<bool()>& should_stop);

}  // namespace smore
