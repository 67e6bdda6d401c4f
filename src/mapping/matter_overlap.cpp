// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/matter_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace smore {
namespace {

bool moreHypotheses(const MaskedPoint& a, const MaskedPoint& b) {
  return __builtin_popcountll(a.mask) > __builtin_popcountll(b.mask);
}

// Distances that worlds differ in where surfaces are known to a spread.
constexpr int kLevels = 8;
constexpr float kLeastDistance = 0.25F;  // of the mean

// The worlds of one level have surfaces of all sizes, which grow with their numbers.
int levelOf(int world) { return (5 * world + world / kLevels) % kLevels; }

// What has matter nearer than the distance of its world, by places in a grid.
MaskGrid nearTo(const std::vector<MaskedPoint>& points, TouchDistance distance, float cell,
                bool planar) {
  if (distance.spread <= 0.0F) return {points, distance.mean, cell, planar};
  std::array<HypothesisMask, kLevels> worlds{};
  for (int m = 0; m < kHypotheses; ++m) worlds[levelOf(m)] |= HypothesisMask{1} << m;
  MaskGrid result(cell, planar);
  for (int level = 0; level < kLevels; ++level) {
    std::vector<MaskedPoint> part = points;
    for (MaskedPoint& point : part) point.mask &= worlds[level];
    const float share = (2.0F * static_cast<float>(level) + 1.0F) / kLevels - 1.0F;
    const float radius = distance.mean + share * distance.spread;
    result.add({part, std::max(radius, kLeastDistance * distance.mean), cell, planar});
  }
  return result;
}

// Looked up together, so that memory is waited for once and not for each.
constexpr std::size_t kTogether = 32;

// Masks of places in a grid.
class Lookups {
 public:
  explicit Lookups(const MaskGrid* grid) : grid_(grid) {}

  // The place counts where `mask` says.
  void add(const Eigen::Vector3f& point, HypothesisMask mask) {
    places_[count_] = grid_->placeOf(point);
    masks_[count_++] = mask;
  }
  bool full() const { return count_ == kTogether; }

  // The masks of the places in the order in which they were added; then there are none.
  const std::array<HypothesisMask, kTogether>& take() {
    std::array<const HypothesisMask*, kTogether> found;
    for (std::size_t i = 0; i < count_; ++i) found[i] = grid_->maskAt(places_[i]);
    for (std::size_t i = 0; i < count_; ++i) masks_[i] &= *found[i];
    count_ = 0;
    return masks_;
  }

  HypothesisMask takeUnion() {
    const std::size_t count = count_;
    const auto& masks = take();
    return std::accumulate(masks.begin(), masks.begin() + count, HypothesisMask{0},
                           std::bit_or<>());
  }

 private:
  const MaskGrid* grid_;
  std::size_t count_ = 0;
  std::array<MaskBricks::Place, kTogether> places_;
  std::array<HypothesisMask, kTogether> masks_;
};

}  // namespace

MatterOverlap::MatterOverlap(const std::vector<MaskedPoint>& object,
                             const std::vector<MaskedPoint>& world, TouchDistance distance,
                             float block, bool planar)
    : object_moves_(object.size() <= world.size()) {
  const float half_diagonal = 0.5F * block * std::sqrt(planar ? 2.0F : 3.0F);
  const std::vector<MaskedPoint>& fixed = object_moves_ ? world : object;
  // A half and a whole cell of the lattice on which touched points lie.
  near_ball_ = nearTo(fixed, distance, distance.mean / 6.0F, planar);
  // One more cell than the geometry needs makes up for the lattices' rounding.
  near_block_ = MaskGrid(fixed, 1.4F * (distance.mean + distance.spread) + half_diagonal,
                         distance.mean / 3.0F, planar);
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
  HypothesisMask result = 0;
  for (std::size_t first = 0; first < blocks_.size(); first += kTogether) {
    addOverlaps(first, std::min(first + kTogether, blocks_.size()), pose, &result);
    if (__builtin_popcountll(result) > enough) break;
  }
  return result;
}

void MatterOverlap::addOverlaps(std::size_t first, std::size_t last, const Eigen::Isometry3f& pose,
                                HypothesisMask* result) const {
  Lookups blocks(&near_block_);
  for (std::size_t i = first; i < last; ++i) {
    blocks.add(pose * blocks_[i].whole.point, blocks_[i].whole.mask);
  }
  const auto& near = blocks.take();
  Lookups balls(&near_ball_);
  for (std::size_t i = first; i < last; ++i) {
    const HypothesisMask open = near[i - first] & ~*result;
    if (open == 0) continue;
    for (int k = blocks_[i].first; k < blocks_[i].last; ++k) {
      const HypothesisMask mask = points_[k].mask & open & ~*result;
      if (mask == 0) continue;
      balls.add(pose * points_[k].point, mask);
      if (balls.full()) *result |= balls.takeUnion();
    }
  }
  *result |= balls.takeUnion();
}

}  // namespace smore
