// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/sampled_worlds.h"

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

SampledWorlds::SampledWorlds(const WorldSamples& samples, const FeatureParameters& feature,
                             const ExtentParameters& extent, bool planar, std::uint64_t seed)
    : contact_distance_(feature.conflictDistance()) {
  const SurfaceExtents surfaces(samples, feature, extent, planar, seed);
  object_ = surfaces.object();
  world_ = surfaces.world();
  const auto distance = static_cast<float>(contact_distance_);
  const float block = kBlockSizes * distance;
  const float half_diagonal = 0.5F * block * std::sqrt(planar ? 2.0F : 3.0F);
  near_world_ = MaskGrid(world_, distance, distance / 5.0F);
  // One more cell than the geometry needs makes up for the lattices' rounding.
  near_block_ = MaskGrid(world_, 1.4F * distance + half_diagonal, distance / 2.5F);
  makeBlocks(block);
}

void SampledWorlds::makeBlocks(float size) {
  std::map<std::uint64_t, std::vector<MaskedPoint>> groups;
  for (const MaskedPoint& point : object_) {
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
  object_.clear();
  for (const auto& group : sorted) {
    Block block{group.first, static_cast<int>(object_.size()), 0};
    object_.insert(object_.end(), group.second.begin(), group.second.end());
    block.last = static_cast<int>(object_.size());
    blocks_.push_back(block);
  }
}

HypothesisMask SampledWorlds::touching(const Eigen::Isometry3f& T_map_object) const {
  const Eigen::Matrix3f rotation = T_map_object.linear();
  const Eigen::Vector3f translation = T_map_object.translation();
  HypothesisMask result = 0;
  for (const Block& block : blocks_) {
    const HypothesisMask open = block.whole.mask & ~result;
    if (open == 0) continue;
    const HypothesisMask near = near_block_.at(rotation * block.whole.point + translation) & open;
    if (near == 0) continue;
    for (int i = block.first; i < block.last; ++i) {
      if ((object_[i].mask & near & ~result) == 0) continue;
      result |= near_world_.at(rotation * object_[i].point + translation) & object_[i].mask;
    }
    if (result == ~HypothesisMask{0}) break;
  }
  return result;
}

}  // namespace smore
