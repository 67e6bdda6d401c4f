// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/mask_grid.h"

#include <cmath>

#include "smore/mapping/mask_dilation.h"

namespace smore {

std::uint64_t MaskedPoints::cellKey(const Eigen::Vector3f& point, float cell) {
  constexpr std::int64_t kBias = 1 << 20;  // 21 bits an axis: a kilometre at a millimetre
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key = (key << 21) | static_cast<std::uint64_t>(std::llround(point[axis] / cell) + kBias);
  }
  return key;
}

void MaskedPoints::add(const Eigen::Vector3f& point, HypothesisMask mask) {
  const auto found = index_.emplace(cellKey(point, cell_), points_.size());
  if (found.second) {
    const Eigen::Vector3f center = (point / cell_).array().round().matrix() * cell_;
    points_.push_back({center, 0});
  }
  points_[found.first->second].mask |= mask;
}

MaskGrid::MaskGrid(const std::vector<MaskedPoint>& points, float radius, float cell, bool planar)
    : MaskGrid(cell, planar) {
  for (const MaskedPoint& ball : points) mark(ball.point, ball.mask);
  dilate(radius);
}

void MaskGrid::dilate(float radius) { bricks_ = dilated(bricks_, radius * inverse_cell_); }

}  // namespace smore
