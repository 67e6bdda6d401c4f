// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/point_index.h"

namespace smore {
namespace {

// A box of a metre in cells of a contact's size holds fewer; a few megabytes.
constexpr double kMostCells = 1 << 20;

// The radius, doubled until the box has no more cells than that.
float cellFor(const Eigen::Vector3f& span, float radius) {
  float cell = radius;
  while (((span / cell).array().floor() + 1.0F).cast<double>().prod() > kMostCells) cell *= 2.0F;
  return cell;
}

}  // namespace

int PointIndex::cellOf(const Eigen::Vector3f& point) const {
  const Eigen::Vector3i at = cellsAlong(point);
  return (at.z() * size_.y() + at.y()) * size_.x() + at.x();
}

void PointIndex::build(const std::vector<Eigen::Vector3f>& points) {
  points_.clear();
  if (points.empty()) return;
  Eigen::Vector3f max = points.front();
  min_ = max;
  for (const Eigen::Vector3f& point : points) {
    min_ = min_.cwiseMin(point);
    max = max.cwiseMax(point);
  }
  cell_ = cellFor(max - min_, radius_);
  size_ = cellsAlong(max) + Eigen::Vector3i::Ones();
  first_.assign(static_cast<std::size_t>(size_.prod()) + 1, 0);
  for (const Eigen::Vector3f& point : points) ++first_[cellOf(point) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  points_.resize(points.size());
  original_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int slot = next[cellOf(points[i])]++;
    points_[slot] = points[i];
    original_[slot] = static_cast<int>(i);
  }
  markNeighbours();
}

void PointIndex::markNeighbours() {
  has_neighbours_.assign(static_cast<std::size_t>((size_.array() + 2).prod()), false);
  for (const Eigen::Vector3f& point : points_) {
    const Eigen::Vector3i at = cellsAlong(point);
    for (int z = -1; z <= 1; ++z) {
      for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
          has_neighbours_[marginCellOf(at + Eigen::Vector3i(x, y, z))] = true;
        }
      }
    }
  }
}

}  // namespace smore
