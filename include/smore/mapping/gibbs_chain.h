// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "smore/mapping/joint_distribution.h"

namespace smore {

/// One chain of Gibbs sampling of a JointDistribution at a temperature: with what binds the
/// contacts to one another and to free space raised to the power `heat` in [0, 1]. Views of its
/// arguments.
class GibbsChain {
 public:
  GibbsChain(const std::vector<ContactHypotheses>& contacts, const FreeSpaceEvidence& evidence,
             const DistributionParameters& parameters);

  /// Draws each contact anew given all others, once, in a random order.
  void sweep(double heat, std::uint64_t seed);

  /// What `heat` multiplies in the log density: attraction less the cost of conflicts.
  double binding() const;

  const Explanation& explanation() const { return places_; }

 private:
  using Row = std::array<float, kCandidates>;

  std::vector<int> visitOrder(std::uint64_t seed) const;
  void remove(int contact);
  void add(int contact, int place);
  void changeSums(int contact, float sign);
  int draw(int contact, double heat, std::uint64_t seed) const;
  void logWeights(int contact, double heat, Row* log_weight) const;
  void addAttraction(int contact, const PointArray& places, const std::vector<Eigen::Vector3f>& at,
                     const std::vector<float>& sums, const AttractionParameters& attraction,
                     Row* log_weight) const;
  void countConflicts(int contact, Row* conflicts) const;

  const std::vector<ContactHypotheses>* contacts_;
  const FreeSpaceEvidence* evidence_;
  const DistributionParameters* parameters_;
  Explanation places_;
  std::vector<Eigen::Vector3f> object_;  ///< chosen balls' centres; only where a place is chosen
  std::vector<Eigen::Vector3f> world_;
  std::vector<float> object_sums_;  ///< of the kernels of all other contacts
  std::vector<float> world_sums_;
};

}  // namespace smore
