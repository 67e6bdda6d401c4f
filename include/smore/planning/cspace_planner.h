// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/planning/cspace_memory.h"
#include "smore/planning/path_planner.h"
#include "smore/planning/planner.h"

namespace smore {

/// The paper's baseline: around the remembered contact poses, with no idea of shapes.
class CspacePlanner : public Planner {
 public:
  /// `memory` must outlive the planner. Call i (from 0) draws its samples from `seed` + i.
  /// std::invalid_argument for parameters out of their ranges.
  CspacePlanner(const CspaceMemory& memory, const MotionSpace& space,
                const PathPlannerParameters& parameters, std::uint32_t seed);

  /// `start` is where the object stands now, free of contact (CspaceMemory::isValid). The risk is
  /// 0: the memory knows poses, not probabilities.
  Result<Plan> plan(const Pose& start, const Pose& goal) override;

 private:
  const CspaceMemory& memory_;
  MotionSpace space_;
  PathPlannerParameters parameters_;
  std::uint32_t seed_;
};

}  // namespace smore
