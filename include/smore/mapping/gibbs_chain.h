// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "smore/mapping/joint_distribution.h"

namespace smore {

/// One run of Gibbs sampling of a JointDistribution: contacts enter one after the other in a random
/// order, then each is drawn anew given all others, sweep after sweep.
class GibbsChain {
 public:
  GibbsChain(const std::vector<ContactHypotheses>& contacts, const FreeSpaceEvidence& evidence,
             const DistributionParameters& parameters, std::uint64_t seed);

  /// The explanation after all sweeps.
  Explanation run();

 private:
  using Row = std::array<float, kCandidates>;

  std::vector<int> visitOrder(int sweep) const;
  void remove(int contact);
  void add(int contact, int place);
  void changeSums(int contact, float sign);
  int draw(int contact, int sweep);
  void logWeights(int contact, Row* log_weight) const;
  void addAttraction(int contact, const PointArray& places, const std::vector<Eigen::Vector3f>& at,
                     const std::vector<float>& sums, const AttractionParameters& attraction,
                     Row* log_weight) const;
  void countConflicts(int contact, Row* conflicts) const;

  const std::vector<ContactHypotheses>& contacts_;
  const FreeSpaceEvidence& evidence_;
  const DistributionParameters& parameters_;
  std::uint64_t seed_;
  Explanation places_;
  std::vector<bool> entered_;
  std::vector<Eigen::Vector3f> object_;  ///< chosen balls' centres; only where a place is chosen
  std::vector<Eigen::Vector3f> world_;
  std::vector<float> object_sums_;  ///< of the kernels of all other contacts
  std::vector<float> world_sums_;
};

}  // namespace smore
