// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "smore/mapping/gibbs_chain.h"

namespace smore {

/// A chain and the seed of its random numbers in one sweep.
struct SweptChain {
  GibbsChain* chain;
  std::uint64_t seed;
};

/// Draws each contact of some chains anew given all others, contact by contact in one order: with
/// what binds the contacts to one another and to free space raised to the power `heat` in [0, 1].
///
/// What a touch at one place says about all places of another contact is worked out once for all
/// chains that have it there: most of the time of the belief would go into it. What a chain draws
/// does not depend on the others.
class GibbsSweep {
 public:
  /// Views of its arguments.
  GibbsSweep(const std::vector<ContactHypotheses>& contacts, const FreeSpaceEvidence& evidence,
             const PriorEvidence& prior, const DistributionParameters& parameters,
             std::vector<SweptChain> chains, double heat);

  /// The contacts in this order, then the pieces of prior knowledge.
  void run(const std::vector<int>& order);

 private:
  using Row = std::array<float, kCandidates>;

  /// Kernels of one contact's places and one touch; 0 outside of [first, last).
  struct KernelRow {
    Row kernels;
    int place = 0;  ///< of the touch
    int first = 0;
    int last = 0;
  };
  /// What the touches of one map, as one chain has them, say about the places of a contact.
  struct Attraction {
    Row sum;  ///< of the kernels
    /// The product of all factors is `factor` times two to the power `exponent`.
    Row factor;
    std::array<std::int32_t, kCandidates> exponent;
  };
  using SideOf = const GibbsChain::Side& (GibbsChain::*)() const;

  void visit(int contact);
  void judge(int piece, const SweptChain& swept) const;
  void attract(int contact, MapSide side, const PointArray& places, const PointArray& normals);
  void attractTo(int contact, int other, SideOf side_of, const PointArray& places,
                 const PointArray& normals);
  const KernelRow& rowOf(int place, const GibbsChain::Side& side, int other, int count,
                         const PointArray& places, const PointArray& normals);
  int draw(int contact, const SweptChain& swept, const Attraction& attraction) const;
  void countConflicts(int contact, const GibbsChain& chain, Row* conflicts) const;

  static void fillRow(const GibbsChain::Side& side, int other, int count, const PointArray& places,
                      const PointArray& normals, KernelRow* row);
  static void multiply(const KernelRow& row, float gain, Attraction* attraction);
  static void keepMantissas(Attraction* attraction);

  const std::vector<ContactHypotheses>& contacts_;
  const FreeSpaceEvidence& evidence_;
  const PriorEvidence& prior_;
  const DistributionParameters& parameters_;
  std::vector<SweptChain> chains_;
  double heat_;
  float exponent_;
  float cost_;
  std::vector<Attraction> attractions_;  ///< by chain
  std::vector<KernelRow> rows_;          ///< of the touch that is looked at, as many as are known
  std::array<std::int16_t, kCandidates> row_of_place_;
  std::size_t known_rows_ = 0;
};

}  // namespace smore
