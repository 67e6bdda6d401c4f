// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "smore/mapping/gibbs_chain.h"

namespace smore {

/// A population of Gibbs chains that cools together (a sequential Monte Carlo sampler over
/// temperatures, Del Moral et al. 2006). Chains that the next temperature makes more likely are
/// continued more often. Contacts that must move together to a better explanation hardly ever do so
/// one at a time; here the chains that happened on it take over. Chains are swept on all processor
/// cores; what comes out does not depend on how many there are.
class TemperedPopulation {
 public:
  TemperedPopulation(const std::vector<ContactHypotheses>& contacts,
                     const FreeSpaceEvidence& evidence, const PriorEvidence& prior,
                     const DistributionParameters& parameters, int count, std::uint64_t seed);

  std::vector<JointSample> run();

 private:
  std::vector<double> bindingOfChains() const;
  /// Their indices, those with the same explanation side by side.
  std::vector<std::size_t> chainsByExplanation() const;
  /// The next step of the heat, at most `left`: the density's range grows with the contacts, and a
  /// step that one chain in a few survives would lose what the others had found.
  double nextStep(const std::vector<double>& bindings, double left) const;
  /// Continues each chain as often as its weight says.
  void resample(const std::vector<double>& weights, std::uint64_t seed);
  /// Chain m is to be there `copies[m]` times: it stays where it is, and its further copies take
  /// the places of chains that end, so that a small change of the evidence changes few chains.
  void continueChains(std::vector<int> copies);
  void sweep(double heat, std::uint64_t seed);
  /// Of the contacts: random, and by their ids alone.
  std::vector<int> visitOrder(std::uint64_t seed) const;

  const std::vector<ContactHypotheses>& contacts_;
  const FreeSpaceEvidence& evidence_;
  const PriorEvidence& prior_;
  DistributionParameters parameters_;
  std::uint64_t seed_;
  std::vector<GibbsChain> chains_;
};

}  // namespace smore
