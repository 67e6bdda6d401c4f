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

  /// The chosen balls of one map, by contact; valid only where a place is chosen.
  struct Side {
    Side(std::size_t contacts, const AttractionParameters& attraction);

    void place(int contact, const PointArray& places, const PointArray& normals, int place);
    /// The kernel of two chosen balls.
    float between(int a, int b) const;

    AttractionKernel kernel;
    float base;
    std::vector<Eigen::Vector3f> centers;
    std::vector<Eigen::Vector3f> normals;
    std::vector<float> sums;  ///< of the kernels of all other contacts
  };

  std::vector<int> visitOrder(std::uint64_t seed) const;
  void remove(int contact);
  void add(int contact, int place);
  void changeSums(int contact, float sign);
  int draw(int contact, double heat, std::uint64_t seed) const;
  void logWeights(int contact, double heat, Row* log_weight) const;
  void addAttraction(int contact, const Side& side, const PointArray& places,
                     const PointArray& normals, Row* log_weight) const;
  void countConflicts(int contact, Row* conflicts) const;

  const std::vector<ContactHypotheses>* contacts_;
  const FreeSpaceEvidence* evidence_;
  const DistributionParameters* parameters_;
  Explanation places_;
  Side object_;
  Side world_;
};

}  // namespace smore
