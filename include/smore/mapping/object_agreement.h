// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/joint_distribution.h"

namespace smore {

/// Where a touch on the object is expected.
struct TouchLengths {
  double spread;  ///< around an earlier one: breadth of Student's t [m], positive
  double reach;   ///< from the hand, where nothing foresees it [m], positive
  double widest;  ///< from the hand, where the contact is held to be false: the same for all units
                  ///< of length that are compared [m], positive
  bool planar;    ///< t has two degrees of freedom, else one; densities are in m^-2, else in m^-3
};

/// How well the touches on the object foresee one another, docs/belief.md (U2) [nats; the logarithm
/// of a density], on average over the samples: each touch was expected at the touches before it in
/// the order of the contacts or, with the weight of one touch, anywhere within the reach. Contacts
/// that are held to be false, and the `elsewhere` that the samples know nothing of, say nothing of
/// the object.
double objectAgreement(const std::vector<ContactHypotheses>& contacts,
                       const std::vector<JointSample>& samples, const TouchLengths& lengths,
                       int elsewhere);

}  // namespace smore
