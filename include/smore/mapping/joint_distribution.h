// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_space_evidence.h"

namespace smore {

/// Prior belief about how touches lie to one another, in one of the two maps.
struct AttractionParameters {
  double scale = 0.05;  ///< distance at which two touches hardly speak for one another any more [m]
  double base = 0.1;    ///< weight of matter never touched before, against one earlier touch here
};

struct DistributionParameters {
  AttractionParameters object{0.05, 0.1};
  AttractionParameters world{0.05, 0.05};
  double exponent = 1.0;       ///< of the attraction; 0.5 counts each pair once, 1 from either side
  double conflict_cost = 4.0;  ///< log odds against one contradiction with free space
  double false_contact = 0.02;  ///< probability that a contact tells nothing
  int temperatures = 12;        ///< steps from independent contacts to the whole distribution
  int sweeps = 3;               ///< of Gibbs sampling after the last of these steps
};

/// One explanation of all contacts: for each its place, or kFalseContact.
using Explanation = std::vector<std::int16_t>;
constexpr std::int16_t kFalseContact = -1;

/// The joint distribution of the places of all contacts, given all free space (docs/belief.md).
///
///   P(s) ~ prod_k prior(s_k) * prod_k [(1 + A_k / a)(1 + B_k / b)]^exponent * exp(-cost *
///   conflicts)
///
/// A_k is the sum over the other contacts of kernel(|o_k - o_l| / scale) on the object, B_k the
/// same in the world. One normalised distribution: the conditionals that are sampled are its own.
class JointDistribution {
 public:
  /// Views that must outlive this. Contacts in the order of `evidence`.
  JointDistribution(const std::vector<ContactHypotheses>& contacts,
                    const FreeSpaceEvidence& evidence, const DistributionParameters& parameters);

  /// Unnormalised log probability.
  double logDensity(const Explanation& explanation) const;

  /// `count` explanations: a tempered population of Gibbs chains (docs/belief.md). The contacts'
  /// order does not matter: each draws from the seed and its own id, in an order of visits that the
  /// ids give.
  std::vector<Explanation> sample(int count, std::uint64_t seed) const;

 private:
  const std::vector<ContactHypotheses>* contacts_;
  const FreeSpaceEvidence* evidence_;
  DistributionParameters parameters_;
};

/// Compact bell: 1 at 0, 1/4 at about 1, exactly 0 from 6 on. `squared` is the squared distance
/// over the squared scale. Inline, for the sake of vector instructions: the sampler's time goes
/// here.
inline float attractionKernel(float squared) {
  constexpr float kEnd = 1.0F / (37.0F * 37.0F);  // value of the bell at distance 6
  const float bell = 1.0F / ((1.0F + squared) * (1.0F + squared));
  return std::max(0.0F, bell - kEnd);
}

}  // namespace smore
