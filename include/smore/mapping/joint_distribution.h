// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_space_evidence.h"
#include "smore/mapping/prior_evidence.h"

namespace smore {

/// How touches lie to one another.
enum class AttractionShape {
  kPoint,    ///< around points: a held thing is touched at its corners again and again
  kSurface,  ///< along surfaces of any size: what things stand on and behind goes on
};

/// Prior belief about how touches lie to one another, in one of the two maps. The scale is in
/// metres where it is used, by default in units of length.
struct AttractionParameters {
  AttractionShape shape;
  double scale;  ///< distance from which on two touches speak less for one another
  double base;   ///< weight of matter never touched before, against one earlier touch here
};

struct DistributionParameters {
  AttractionParameters object{AttractionShape::kPoint, 0.3, 0.1};
  AttractionParameters world{AttractionShape::kSurface, 0.5, 0.05};
  double exponent = 2.0;       ///< strength of the attraction; 0.5 counts each pair of touches once
  double conflict_cost = 4.0;  ///< log odds against one contradiction with free space
  double false_contact = 0.02;  ///< probability that a contact tells nothing
  int temperatures =
      12;  ///< least number of steps from independent contacts to the whole distribution
  double least_share = 0.3;  ///< of the chains that must count after a step; else it is halved
  int sweeps = 3;            ///< of Gibbs sampling after the last of these steps
};

constexpr std::int16_t kFalseContact = -1;

/// One explanation of all contacts: for each its place, or kFalseContact.
using Explanation = std::vector<std::int16_t>;

/// Contradictions with free space among the contacts of an explanation: C of docs/belief.md (B4).
int contradictions(const Explanation& explanation, const FreeSpaceEvidence& evidence);

/// An explanation together with the pieces of prior knowledge that it holds to be true.
struct JointSample {
  Explanation places;
  PriorMask believed = 0;
};

/// The joint distribution of the places of all contacts, given all free space: docs/belief.md (B4).
///
///   P(s) ~ prod_k prior(s_k) * prod_k [(1 + A_k / a)(1 + B_k / b)]^exponent * exp(-cost *
///   conflicts)
///
/// A_k is the sum of the object's AttractionKernel over the other contacts, B_k that of the
/// world's. One normalised distribution: the conditionals that are sampled are its own. With prior
/// knowledge, docs/belief.md (B7), each piece of it is true or not, with its odds; what is true
/// pulls touches to its surfaces (in A_k and B_k) and may be contradicted, like free space.
class JointDistribution {
 public:
  /// Views that must outlive this. Contacts in the order of `evidence` and of `prior`.
  JointDistribution(const std::vector<ContactHypotheses>& contacts,
                    const FreeSpaceEvidence& evidence, const PriorEvidence& prior,
                    const DistributionParameters& parameters);

  /// `count` samples: a tempered population of Gibbs chains (docs/belief.md). The contacts' order
  /// does not matter: each draws from the seed and its own id, in an order of visits that the ids
  /// give.
  std::vector<JointSample> sample(int count, std::uint64_t seed) const;

 private:
  const std::vector<ContactHypotheses>* contacts_;
  const FreeSpaceEvidence* evidence_;
  const PriorEvidence* prior_;
  DistributionParameters parameters_;
};

/// How strongly two touches speak for one another, from 0 to 1 where they are at one place. Inline,
/// for the sake of vector instructions: the sampler's time goes here. With the distance d and the
/// scale h,
///
///   kPoint     1 / (1 + (d / h)^2)^2, less its value at d = 6 h, so that it ends there
///   kSurface   1 / ((1 + (z / h)^2)^2 (1 + (d / h)^2))
///
/// as in docs/belief.md (B5) and docs/belief.md (B6), where z^2 is the mean square of the heights
/// of each touch above the other's tangent plane: along a surface the kernel falls as the inverse
/// square of the distance, so that no size of surfaces is preferred.
class AttractionKernel {
 public:
  explicit AttractionKernel(const AttractionParameters& parameters)
      : surface_(parameters.shape == AttractionShape::kSurface),
        inverse_square_(static_cast<float>(1.0 / (parameters.scale * parameters.scale))) {}

  /// Of two touches `between` [m] apart that have these unit normals.
  float operator()(const Eigen::Vector3f& between, const Eigen::Vector3f& normal,
                   const Eigen::Vector3f& other_normal) const {
    const float height = normal.dot(between);
    const float other_height = other_normal.dot(between);
    return of(between.squaredNorm(), height * height + other_height * other_height);
  }

  /// By the squared distance and the sum of both squared heights [m^2].
  float of(float squared_distance, float squared_heights) const {
    constexpr float kEnd = 1.0F / (37.0F * 37.0F);
    const float distance = 1.0F + squared_distance * inverse_square_;
    if (!surface_) return std::max(0.0F, 1.0F / (distance * distance) - kEnd);
    const float height = 1.0F + 0.5F * squared_heights * inverse_square_;
    return 1.0F / (height * height * distance);
  }

 private:
  bool surface_;
  float inverse_square_;
};

}  // namespace smore
