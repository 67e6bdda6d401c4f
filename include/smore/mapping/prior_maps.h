// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/mapping/prior.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// What the sources of `scene.prior` say, on lattices that are finer than the maps. The truth is
/// that of the solids of `scene`: as perturbed in a trial. In planar motion what lies in the plane
/// counts. InputError, with file and remedy, for a file that cannot be read, a source that says
/// nothing in its box, or the truth where there is no scene: all of these at once, one a line.
Priors makePriors(const Scenario& scene);

/// The same of one source, for one map of `scene`.
Prior makePrior(const Scenario& scene, MapSide side, const PriorSource& source);

}  // namespace smore
