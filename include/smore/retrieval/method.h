// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "smore/mapping/prior.h"
#include "smore/mapping/twin_map.h"
#include "smore/planning/planner.h"
#include "smore/retrieval/method_kind.h"
#include "smore/retrieval/method_parameters.h"
#include "smore/retrieval/touch_planner.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// What learns and what plans, put together for one method.
struct Method {
  std::unique_ptr<TwinMap> maps;            ///< empty for ever where `memory` learns instead
  std::unique_ptr<ContactObserver> memory;  ///< what learns instead of the maps; null if they do
  std::unique_ptr<Planner> planner;         ///< refers to what learns
  std::unique_ptr<TouchPlanner> touches;    ///< the same; for when maps are wanted, not a goal

  /// Hands an observation to what learns.
  void observe(const ContactObservation& observation) {
    (memory ? *memory : static_cast<ContactObserver&>(*maps)).observe(observation);
  }
};

/// Touches that tell most by what `method` has learnt, which must be smore; a view of it. Its own
/// touches are these in planar motion, and in space random ones, of which maps get better there
/// (docs/touches.md).
std::unique_ptr<TouchPlanner> makeInformedTouches(const Method& method, const Scenario& scenario,
                                                  std::uint64_t seed);

/// InputError where a method cannot use what is known beforehand, or lacks what it must be told:
/// only smore takes it all, and chs needs the object's shape, and nothing of the world.
void checkPriors(MethodKind kind, const Priors& priors);

/// The twin map of a method. What it may know of the scenario: voxel size, workspace, motion, and
/// the sensor's declared noise; never the shapes, but by `priors` (checkPriors). Of `parameters` it
/// uses its own (takesParameters).
std::unique_ptr<TwinMap> makeTwinMap(MethodKind kind, const Scenario& scenario, std::uint64_t seed,
                                     const MethodParameters& parameters = {},
                                     const Priors& priors = {});

/// A whole method; `seed` makes its random choices repeatable. The rest as above.
Method makeMethod(MethodKind kind, const Scenario& scenario, std::uint64_t seed,
                  const MethodParameters& parameters = {}, const Priors& priors = {});

}  // namespace smore
