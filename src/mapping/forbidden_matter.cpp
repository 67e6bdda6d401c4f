// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/forbidden_matter.h"

#include <cmath>

#include "smore/common/cell_key.h"

namespace smore {
namespace {

// Cells of a tile along x and y, and along z: not much larger than the balls that are swept through
// it, so that little is made that nobody asks for.
constexpr int kPlanarSide = 32;
constexpr int kSpatialSide = 16;

CellBox tileWith(const MaskBricks::Cell& cell, bool planar) {
  return planar ? boxAround(cell, kPlanarSide, 1) : boxAround(cell, kSpatialSide, kSpatialSide);
}

// Of a ball around a tile, with as much more as balls overlap: what marks a cell in there may be
// centred half a diagonal beside it.
float reachOf(float distance, float cell, bool planar) {
  const CellBox tile = tileWith({}, planar);
  const auto side = static_cast<float>(tile.side);
  const auto layers = static_cast<float>(tile.layers);
  const float half_diagonal = 0.5F * std::sqrt(2.0F * side * side + layers * layers);
  return distance + cell * (half_diagonal + 1.0F);
}

std::vector<Eigen::Vector3f> placesOf(const std::vector<MaskedPoint>& balls) {
  std::vector<Eigen::Vector3f> places;
  places.reserve(balls.size());
  for (const MaskedPoint& ball : balls) places.push_back(ball.point);
  return places;
}

}  // namespace

ForbiddenMatter::ForbiddenMatter(const std::vector<MaskedPoint>& other,
                                 const std::vector<Eigen::Isometry3f>& poses, float distance,
                                 float cell, bool planar)
    : other_(other),
      poses_(poses),
      radius_(distance * (1.0F / cell)),
      cell_(cell),
      planar_(planar),
      lattice_(cell, planar),
      near_tile_(reachOf(distance, cell, planar)),
      tiles_(std::make_unique<Tiles>()) {
  near_tile_.build(placesOf(other_));
  inverse_poses_.reserve(poses_.size());
  for (const Eigen::Isometry3f& T : poses_) inverse_poses_.push_back(T.inverse());
}

HypothesisMask ForbiddenMatter::at(const Eigen::Vector3f& point) const {
  if (other_.empty()) return 0;
  const MaskBricks::Cell cell = lattice_.cellAt(point);
  const CellBox tile = tileWith(cell, planar_);
  Tile& known = tileAt(tile);
  std::call_once(known.swept, [&] { known.matter = sweptThrough(tile); });
  return known.matter.at(cell);
}

ForbiddenMatter::Tile& ForbiddenMatter::tileAt(const CellBox& tile) const {
  const auto& [lowest, side, layers] = tile;
  const std::uint64_t key = cellKey(lowest[0] / side, lowest[1] / side, lowest[2] / layers);
  const std::lock_guard<std::mutex> lock(tiles_->finding);
  return tiles_->by_place[key];
}

MaskBox ForbiddenMatter::sweptThrough(const CellBox& tile) const {
  const Eigen::Vector3f lowest = Eigen::Array3i::Map(tile.lowest.data()).cast<float>();
  const Eigen::Array3i last(tile.side - 1, tile.side - 1, tile.layers - 1);
  const Eigen::Vector3f center = cell_ * (lowest + 0.5F * last.cast<float>().matrix());
  MaskBox swept(widened(tile, radius_, planar_));
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    near_tile_.forNear(inverse_poses_[i] * center, [&](int ball) {
      swept.mark(lattice_.cellAt(poses_[i] * other_[ball].point), other_[ball].mask);
    });
  }
  return dilated(swept, radius_, planar_, tile);
}

}  // namespace smore
