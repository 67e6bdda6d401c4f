// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/forbidden_matter.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace smore {
namespace {

// Of the region's diagonal: balls that lie together are passed over together.
constexpr float kBlockShare = 0.25F;

constexpr float kHair = 1e-3F;

struct Block {
  std::vector<MaskedPoint> balls;
  Eigen::AlignedBox3f extent;
};

std::vector<Block> blocksOf(const std::vector<MaskedPoint>& balls, float size) {
  std::unordered_map<std::uint64_t, std::size_t> index;
  std::vector<Block> blocks;
  for (const MaskedPoint& ball : balls) {
    const std::uint64_t key = MaskedPoints::cellKey(ball.point, size);
    const std::size_t block = index.emplace(key, blocks.size()).first->second;
    if (block == blocks.size()) blocks.emplace_back();
    blocks[block].balls.push_back(ball);
    blocks[block].extent.extend(ball.point);
  }
  return blocks;
}

// A hair more than the geometry needs makes up for rounding.
bool mayComeInto(const Eigen::AlignedBox3f& region, const Block& block,
                 const Eigen::Isometry3f& T) {
  const float radius = 0.5F * block.extent.diagonal().norm();
  const float hair = kHair * (radius + region.diagonal().norm());
  const Eigen::Vector3f center = block.extent.center();
  return region.exteriorDistance(T * center) <= radius + hair;
}

}  // namespace

ForbiddenMatter::ForbiddenMatter(const std::vector<MaskedPoint>& other,
                                 const std::vector<Eigen::Isometry3f>& poses,
                                 const Eigen::AlignedBox3f& region, float distance, float cell,
                                 bool planar)
    : swept_(cell, planar) {
  if (region.isEmpty()) return;
  const std::vector<Block> blocks =
      blocksOf(other, std::max(cell, kBlockShare * region.diagonal().norm()));
  for (const Eigen::Isometry3f& T : poses) {
    for (const Block& block : blocks) {
      if (!mayComeInto(region, block, T)) continue;
      for (const MaskedPoint& ball : block.balls) {
        const Eigen::Vector3f center = T * ball.point;
        if (region.contains(center)) swept_.mark(center, ball.mask);
      }
    }
  }
  swept_.dilate(distance);
}

Eigen::AlignedBox3f boxAround(const std::vector<MaskedPoint>& points, float margin) {
  Eigen::AlignedBox3f box;
  for (const MaskedPoint& point : points) box.extend(point.point);
  if (box.isEmpty()) return box;
  const Eigen::Vector3f margins = Eigen::Vector3f::Constant(margin);
  return {box.min() - margins, box.max() + margins};
}

}  // namespace smore
