// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/worlds_at_unit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "smore/mapping/surface_extents.h"

namespace smore {
namespace {

// Two contact distances: coarse enough to skip much, fine enough to be mostly right.
constexpr float kBlockSizes = 2.0F;

bool moreHypotheses(const MaskedPoint& a, const MaskedPoint& b) {
  return __builtin_popcountll(a.mask) > __builtin_popcountll(b.mask);
}

}  // namespace

WorldsAtUnit::WorldsAtUnit(const WorldSamples& samples, const FeatureParameters& feature,
                           const ExtentParameters& extent, bool planar, std::uint64_t seed)
    : radius_(feature.radius),
      contact_distance_(feature.conflictDistance()),
      members_(samples.members) {
  const SurfaceExtents surfaces(samples, feature, extent, planar, seed);
  object_ = surfaces.object();
  world_ = surfaces.world();
  const auto distance = static_cast<float>(contact_distance_);
  const float block = kBlockSizes * distance;
  const float half_diagonal = 0.5F * block * std::sqrt(planar ? 2.0F : 3.0F);
  object_moves_ = object_.size() <= world_.size();
  const std::vector<MaskedPoint>& fixed = object_moves_ ? world_ : object_;
  // A half and a whole cell of the lattice on which the points lie.
  near_ball_ = MaskGrid(fixed, distance, distance / 6.0F, planar);
  // One more cell than the geometry needs makes up for the lattices' rounding.
  near_block_ = MaskGrid(fixed, 1.4F * distance + half_diagonal, distance / 3.0F, planar);
  makeBlocks(object_moves_ ? object_ : world_, block);
}

void WorldsAtUnit::makeBlocks(const std::vector<MaskedPoint>& points, float size) {
  std::map<std::uint64_t, std::vector<MaskedPoint>> groups;
  for (const MaskedPoint& point : points) {
    groups[MaskedPoints::cellKey(point.point, size)].push_back(point);
  }
  std::vector<std::pair<MaskedPoint, std::vector<MaskedPoint>>> sorted;
  for (auto& group : groups) {
    std::stable_sort(group.second.begin(), group.second.end(), moreHypotheses);
    MaskedPoint whole;
    whole.point = (group.second.front().point / size).array().round().matrix() * size;
    for (const MaskedPoint& point : group.second) whole.mask |= point.mask;
    sorted.emplace_back(whole, std::move(group.second));
  }
  // Blocks that hold matter in many hypotheses first: they decide soonest.
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return moreHypotheses(a.first, b.first); });
  for (const auto& group : sorted) {
    Block block{group.first, static_cast<int>(points_.size()), 0};
    points_.insert(points_.end(), group.second.begin(), group.second.end());
    block.last = static_cast<int>(points_.size());
    blocks_.push_back(block);
  }
}

void WorldsAtUnit::setTouching(const Eigen::Isometry3f& T_map_object, double reach) {
  touching_poses_.push_back({T_map_object, static_cast<float>(reach)});
}

bool WorldsAtUnit::isLikeATouchingPose(const Eigen::Isometry3f& T_map_object) const {
  const auto largest = 0.5F * static_cast<float>(contact_distance_);
  return std::any_of(
      touching_poses_.begin(), touching_poses_.end(), [&](const TouchingPose& touching) {
        const float shift =
            (touching.T_map_object.translation() - T_map_object.translation()).norm();
        if (shift > largest) return false;
        const Eigen::Matrix3f turn =
            touching.T_map_object.linear().transpose() * T_map_object.linear();
        return shift + touching.reach * Eigen::AngleAxisf(turn).angle() <= largest;
      });
}

HypothesisMask WorldsAtUnit::touching(const Eigen::Isometry3f& T_map_object, int enough) const {
  if (isLikeATouchingPose(T_map_object)) return members_;
  return overlap(object_moves_ ? T_map_object : T_map_object.inverse(), enough);
}

HypothesisMask WorldsAtUnit::overlap(const Eigen::Isometry3f& pose, int enough) const {
  const Eigen::Matrix3f rotation = pose.linear();
  const Eigen::Vector3f translation = pose.translation();
  HypothesisMask result = 0;
  for (const Block& block : blocks_) {
    const HypothesisMask open = block.whole.mask & ~result;
    if (open == 0) continue;
    const HypothesisMask near = near_block_.at(rotation * block.whole.point + translation) & open;
    if (near == 0) continue;
    for (int i = block.first; i < block.last; ++i) {
      if ((points_[i].mask & near & ~result) == 0) continue;
      result |= near_ball_.at(rotation * points_[i].point + translation) & points_[i].mask;
    }
    if (__builtin_popcountll(result) > enough) break;
  }
  return result;
}

}  // namespace smore
