// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unordered_map>
#include <vector>

#include "smore/mapping/sampled_worlds.h"

namespace smore {

/// Continues the touched surfaces of all sampled explanations at random along their tangents, until
/// free space ends them: first the object's against the touched places of the world, then the
/// world's against the object so found.
class SurfaceExtents {
 public:
  SurfaceExtents(const WorldSamples& samples, const FeatureParameters& feature,
                 const ExtentParameters& extent, bool planar, std::uint64_t seed);

  const std::vector<MaskedPoint>& object() const { return object_.points(); }
  const std::vector<MaskedPoint>& world() const { return world_.points(); }

 private:
  enum class Side { kObject, kWorld };

  void addTouches();
  void growAll(Side side);
  void grow(Side side, int contact, int hypothesis);
  std::vector<Eigen::Vector3f> tangents(const Eigen::Vector3f& normal, std::uint64_t seed) const;
  HypothesisMask contradictions(const Eigen::Vector3f& point);

  const WorldSamples& samples_;
  const FeatureParameters& feature_;
  const ExtentParameters& extent_;
  bool planar_;
  std::uint64_t seed_;
  MaskedPoints object_;
  MaskedPoints world_;
  MaskGrid opposite_;  ///< near matter of the side that does not grow
  std::unordered_map<std::uint64_t, HypothesisMask> known_;  ///< contradictions by cell
  std::vector<Eigen::Isometry3f> poses_;  ///< from the frame of the growing side to the other
};

}  // namespace smore
