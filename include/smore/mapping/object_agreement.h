// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/joint_distribution.h"

namespace smore {

/// How well the touches on the object foresee one another, docs/belief.md (U2) [nats; the logarithm
/// of a density in m^-2 where the motion is `planar`, in m^-3 where it is not], on average over the
/// samples: each touch was expected at the touches before it in the order of the contacts, by
/// Student's t with two degrees of freedom or one and the scale `spread` [m, positive], or, with
/// the weight of one touch, anywhere within `reach` [m, positive] of the hand. So are contacts that
/// are held to be false, and the `elsewhere` that the samples know nothing of.
double objectAgreement(const std::vector<ContactHypotheses>& contacts,
                       const std::vector<JointSample>& samples, double spread, double reach,
                       bool planar, int elsewhere);

}  // namespace smore
