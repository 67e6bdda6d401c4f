// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/experiment/scored_belief.h"
#include "smore/experiment/trial_truth.h"

namespace smore {

/// Where a contact really was, in the object frame [m]: the mean of its points, weighed by their
/// forces along the resultant. Nothing where that mean lies more than 5 mm off one of the true
/// surfaces: the contact had several places, and no line leads to them all.
std::optional<Vec3> truePlace(const ContactObservation& contact, const TrialTruth& truth);

/// Logarithm of the density [nat, per metre] that a belief gives the true place of a contact along
/// its line, docs/scoring.md (E4). Of N worlds, each with its place or a false contact,
///
///   p(t) = [sum_m K(t - t_m) + 1/L] / (N + 1)
///
/// where t is the coordinate along the line, K the normal density with the standard deviation
/// `bandwidth` [m], and L the `range` [m] over which a place of which nothing is known is uniform;
/// a world that holds the contact to be false counts 1/L. In `planar` motion the coordinate is that
/// in the plane. Without places, of a contact that the belief has left out, it is 1/L.
double logPlaceDensity(const std::vector<std::optional<Vec3>>& places, const LineOfAction& line,
                       const Vec3& true_place, double bandwidth, double range, bool planar);

}  // namespace smore
