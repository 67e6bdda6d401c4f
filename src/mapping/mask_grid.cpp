// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/mask_grid.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

constexpr double kMostCells = 2e6;  // 16 MB

// One more than the span holds: the box begins half a cell lower.
unsigned cellsOver(float span, float cell) {
  return static_cast<unsigned>(std::ceil(span / cell)) + 1;
}

}  // namespace

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

MaskGrid::MaskGrid(const std::vector<MaskedPoint>& points, float radius, float cell) {
  if (points.empty()) return;
  Eigen::Vector3f max = points.front().point;
  min_ = max;
  for (const MaskedPoint& ball : points) {
    min_ = min_.cwiseMin(ball.point);
    max = max.cwiseMax(ball.point);
  }
  const bool planar = min_.z() == 0.0F && max.z() == 0.0F;
  const Eigen::Vector3f margin(radius, radius, planar ? 0.0F : radius);
  const Eigen::Vector3f span = max - min_ + 2.0F * margin;
  const double volume = planar ? span.x() * span.y() * cell : span.prod();
  cell_ = std::max(cell, static_cast<float>(std::cbrt(volume / kMostCells)));
  width_ = cellsOver(span.x(), cell_);
  depth_ = cellsOver(span.y(), cell_);
  height_ = cellsOver(span.z(), cell_);
  // Half a cell lower on each axis: points on the edge fall inside, and z = 0 into the middle.
  min_ -= margin + Eigen::Vector3f::Constant(0.5F * cell_);
  inverse_cell_ = 1.0F / cell_;
  masks_.assign(static_cast<std::size_t>(width_) * depth_ * height_, 0);
  for (const MaskedPoint& ball : points) stamp(ball, radius);
}

void MaskGrid::stamp(const MaskedPoint& ball, float radius) {
  const Eigen::Array3f center = (ball.point - min_).array() * inverse_cell_ - 0.5F;
  const float r = radius * inverse_cell_;
  const Eigen::Array3i low = (center - r).ceil().cast<int>().max(0);
  const Eigen::Array3i last = Eigen::Array3i(width_, depth_, height_) - 1;
  const Eigen::Array3i high = (center + r).floor().cast<int>().min(last);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      const float dz = static_cast<float>(z) - center.z();
      const float dy = static_cast<float>(y) - center.y();
      const float left = r * r - dz * dz - dy * dy;
      if (left < 0.0F) continue;
      HypothesisMask* row = &masks_[(z * depth_ + y) * width_];
      for (int x = low.x(); x <= high.x(); ++x) {
        const float dx = static_cast<float>(x) - center.x();
        if (dx * dx < left) row[x] |= ball.mask;
      }
    }
  }
}

}  // namespace smore
