// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/joint_distribution.h"

namespace smore {

/// The `count` contacts (at most all) that can best be left out, because others say in every
/// explanation what they say: indices in the order in which they go, each judged against those that
/// stay. A contact is covered in an explanation by as much as its worse side is: the kernel of the
/// attraction at the nearest other touch on the object, or in the world; one that the explanation
/// holds to be false is covered wholly. What counts is the mean over the explanations.
std::vector<int> coveredContacts(const std::vector<ContactHypotheses>& contacts,
                                 const std::vector<Explanation>& explanations,
                                 const DistributionParameters& parameters, int count);

}  // namespace smore
