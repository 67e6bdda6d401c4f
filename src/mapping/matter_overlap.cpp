// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/matter_overlap.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace smore {
namespace {

bool moreHypotheses(const MaskedPoint& a, const MaskedPoint& b) {
  return __builtin_popcountll(a.mask) > __builtin_popcountll(b.mask);
}

}  // namespace

MatterOverlap::MatterOverlap(const std::vector<MaskedPoint>& object,
                             const std::vector<MaskedPoint>& world, float distance, float block,
                             bool planar)
    : object_moves_(object.size() <= world.size()) {
  const float half_diagonal = 0.5F * block * std::sqrt(planar ? 2.0F : 3.0F);
  const std::vector<MaskedPoint>& fixed = object_moves_ ? world : object;
  // A half and a whole cell of the lattice on which touched points lie.
  near_ball_ = MaskGrid(fixed, distance, distance / 6.0F, planar);
  // One more cell than the geometry needs makes up for the lattices' rounding.
  near_block_ = MaskGrid(fixed, 1.4F * distance + half_diagonal, distance / 3.0F, planar);
  makeBlocks(object_moves_ ? object : world, block);
}

void MatterOverlap::makeBlocks(const std::vector<MaskedPoint>& points, float size) {
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

HypothesisMask MatterOverlap::at(const Eigen::Isometry3f& T_map_object, int enough) const {
  const Eigen::Isometry3f pose = object_moves_ ? T_map_object : T_map_object.inverse();
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
