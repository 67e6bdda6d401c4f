// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

namespace smore {

/// Finds the points near a place: points sorted by the cells of a box, cells along x side by side.
class PointIndex {
 public:
  /// `radius` [m], positive: how near the points are that will be asked for.
  explicit PointIndex(float radius) : radius_(radius), cell_(radius) {}

  /// Replaces all points, which must be finite. Where they lie far apart cells are larger than the
  /// radius, so that they fit into memory: slower to search, and as exact.
  void build(const std::vector<Eigen::Vector3f>& points);

  /// Calls visit(i) for each point i nearer to `place` than the radius.
  template <typename Visit>
  void forNear(const Eigen::Vector3f& place, Visit visit) const {
    if (points_.empty()) return;
    const Eigen::Vector3f scaled = (place - min_) / cell_;
    if (!inside(scaled)) return;
    const Eigen::Vector3i at = scaled.array().floor().matrix().cast<int>();
    if (!has_neighbours_[marginCellOf(at)]) return;
    const int z_end = std::min(at.z() + 1, size_.z() - 1);
    const int y_end = std::min(at.y() + 1, size_.y() - 1);
    for (int z = std::max(at.z() - 1, 0); z <= z_end; ++z) {
      for (int y = std::max(at.y() - 1, 0); y <= y_end; ++y) {
        const int row = (z * size_.y() + y) * size_.x();
        const int first = first_[row + std::max(at.x() - 1, 0)];
        const int last = first_[row + std::min(at.x() + 1, size_.x() - 1) + 1];
        for (int i = first; i < last; ++i) {
          if ((points_[i] - place).squaredNorm() < radius_ * radius_) visit(original_[i]);
        }
      }
    }
  }

 private:
  bool inside(const Eigen::Vector3f& scaled) const {
    return (scaled.array() > -1.0F).all() &&
           (scaled.array() < size_.cast<float>().array() + 1.0F).all();
  }
  Eigen::Vector3i cellsAlong(const Eigen::Vector3f& point) const {
    return ((point - min_) / cell_).array().floor().matrix().cast<int>();
  }
  int cellOf(const Eigen::Vector3f& point) const;
  /// In the box with one more cell on all sides.
  int marginCellOf(const Eigen::Vector3i& at) const {
    return ((at.z() + 1) * (size_.y() + 2) + at.y() + 1) * (size_.x() + 2) + at.x() + 1;
  }
  void markNeighbours();

  float radius_;
  float cell_;  ///< at least the radius [m]
  Eigen::Vector3f min_ = Eigen::Vector3f::Zero();
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<int> first_;               ///< of each cell in points_
  std::vector<Eigen::Vector3f> points_;  ///< in the order of their cells
  /// For each cell of the box and its margin, whether it or one beside it holds points: a bit, so
  /// that empty room is passed over without waiting for memory.
  std::vector<bool> has_neighbours_;
  std::vector<int> original_;  ///< where each stood in the list given to build
};

}  // namespace smore
