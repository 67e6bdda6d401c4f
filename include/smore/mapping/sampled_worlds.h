// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_space_evidence.h"
#include "smore/mapping/hypothesis_weights.h"
#include "smore/mapping/joint_distribution.h"
#include "smore/mapping/mask_grid.h"

namespace smore {

/// How far touched surfaces go on: each world has one radius of all patches around its touches and
/// one of those around the object's, log-uniform from the shortest to the longest.
struct ExtentParameters {
  double shortest = 0.02;       ///< [m]; as large as a patch that is just told from a point
  double object_longest = 0.6;  ///< on the object in planar motion [m]: what a gripper holds
  double world_longest = 0.6;   ///< in the world [m]
};

/// The surroundings of a joint sample: all that SampledWorlds is made from. Views.
struct WorldSamples {
  const std::vector<ContactHypotheses>& contacts;
  const FreeSpaceEvidence& evidence;
  const std::vector<Explanation>& explanations;  ///< kHypotheses of them
};

/// 64 worlds that the evidence allows, side by side in the bits of machine words: each an
/// explanation of all contacts, with the touched surfaces continued at random until free space ends
/// them.
class SampledWorlds {
 public:
  SampledWorlds() = default;
  SampledWorlds(const WorldSamples& samples, const FeatureParameters& feature,
                const ExtentParameters& extent, bool planar, std::uint64_t seed);

  /// From now on the object touches in every world at poses like this one, at which it did touch:
  /// those from which no matter within `reach` [m] of the object frame's origin has moved by more
  /// than half the distance at which two balls touch.
  void setTouching(const Eigen::Isometry3f& T_map_object, double reach);

  /// The worlds in which the object touches at this pose in the map frame. Once they are more than
  /// `enough`, the rest may be missing.
  HypothesisMask touching(const Eigen::Isometry3f& T_map_object,
                          int enough = kHypotheses - 1) const;

  /// Makes some worlds likelier than others; without, all are equally likely.
  void weigh(const HypothesisWeights& weights) { weights_ = weights; }

  /// Probability that the true world is among those in the mask.
  double shareOf(HypothesisMask mask) const { return weights_.shareOf(mask); }

  /// As HypothesisWeights::effectiveCount.
  double effectiveCount() const { return weights_.effectiveCount(); }

  /// Centres of the balls of matter, in the object's and the map's frame.
  const std::vector<MaskedPoint>& object() const { return object_; }
  const std::vector<MaskedPoint>& world() const { return world_; }

  /// Distance of two balls' centres at which they touch [m]; 0 for a world without contacts.
  double contactDistance() const { return contact_distance_; }

 private:
  /// Points that lie together, looked up as one first.
  struct Block {
    MaskedPoint whole;
    int first = 0;
    int last = 0;
  };
  /// A pose at which the object touched, and poses like it.
  struct TouchingPose {
    Eigen::Isometry3f T_map_object;
    float reach;
  };
  bool isLikeATouchingPose(const Eigen::Isometry3f& T_map_object) const;
  void makeBlocks(const std::vector<MaskedPoint>& points, float size);
  HypothesisMask overlap(const Eigen::Isometry3f& pose, int enough) const;

  double contact_distance_ = 0.0;
  HypothesisWeights weights_;
  std::vector<TouchingPose> touching_poses_;
  std::vector<MaskedPoint> object_;
  std::vector<MaskedPoint> world_;
  // The side with fewer points is looked up, point by point, in grids of the other side.
  bool object_moves_ = true;
  std::vector<MaskedPoint> points_;  ///< block after block
  std::vector<Block> blocks_;
  MaskGrid near_ball_;   ///< by the centre of a ball: touches
  MaskGrid near_block_;  ///< by the centre of a block: some point of it may touch
};

}  // namespace smore
