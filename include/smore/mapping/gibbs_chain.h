// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "smore/mapping/joint_distribution.h"

namespace smore {

/// The state of one chain of Gibbs sampling of a JointDistribution: an explanation, with what its
/// touches say for one another, and the pieces of prior knowledge that are held to be true. At
/// first all contacts are false and all pieces untrue. Views of its arguments.
class GibbsChain {
 public:
  /// The chosen balls of one map, by contact; valid only where a place is chosen.
  struct Side {
    Side(std::size_t contacts, const AttractionParameters& attraction);

    void place(int contact, const PointArray& places, const PointArray& normals, int place,
               float known_pull);
    /// The kernel of two chosen balls.
    float between(int a, int b) const;

    AttractionKernel kernel;
    float base;
    std::vector<Eigen::Vector3f> centers;
    std::vector<Eigen::Vector3f> normals;
    std::vector<float>
        sums;  ///< of the kernels of all other contacts and the pulls of what is known
  };

  GibbsChain(const std::vector<ContactHypotheses>& contacts, const FreeSpaceEvidence& evidence,
             const PriorEvidence& prior, const DistributionParameters& parameters);

  /// Takes a contact out of the explanation: a false contact from now on.
  void remove(int contact);
  /// Gives a contact that is false a place; kFalseContact leaves it so.
  void add(int contact, int place);

  /// Holds a piece of prior knowledge to be true, or not.
  void believe(int piece, bool is_true);
  /// What holding the piece to be true adds to binding().
  double bindingOf(int piece) const;

  /// What the temperature acts on in the log density: attraction less the cost of conflicts.
  double binding() const;

  const Explanation& explanation() const { return places_; }
  PriorMask believed() const { return believed_; }
  const Side& object() const { return object_; }
  const Side& world() const { return world_; }

 private:
  void changeSums(int contact, float sign);
  int priorConflicts() const;

  const std::vector<ContactHypotheses>* contacts_;
  const FreeSpaceEvidence* evidence_;
  const PriorEvidence* prior_;
  const DistributionParameters* parameters_;
  Explanation places_;
  PriorMask believed_ = 0;
  Side object_;
  Side world_;
};

}  // namespace smore
