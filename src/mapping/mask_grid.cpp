// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/mask_grid.h"

#include <cmath>

#include "smore/common/cell_key.h"
#include "smore/mapping/mask_dilation.h"

namespace smore {

std::uint64_t MaskedPoints::cellKey(const Eigen::Vector3f& point, float cell) {
  return smore::cellKey(std::llround(point.x() / cell), std::llround(point.y() / cell),
                        std::llround(point.z() / cell));
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
