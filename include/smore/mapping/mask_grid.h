// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace smore {

/// One bit for each sampled explanation of the evidence.
using HypothesisMask = std::uint64_t;
constexpr int kHypotheses = 64;

/// Share of the hypotheses in a mask.
inline double shareOf(HypothesisMask mask) {
  return static_cast<double>(__builtin_popcountll(mask)) / kHypotheses;
}

/// A place and the hypotheses in which it holds matter.
struct MaskedPoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  HypothesisMask mask = 0;
};

/// Points merged where they fall into one cell of a lattice; the cell's centre stands for them.
class MaskedPoints {
 public:
  /// `cell` [m], positive.
  explicit MaskedPoints(float cell) : cell_(cell) {}

  void add(const Eigen::Vector3f& point, HypothesisMask mask);
  const std::vector<MaskedPoint>& points() const { return points_; }
  float cell() const { return cell_; }
  /// The same number for all points of one cell of a lattice of this size.
  static std::uint64_t cellKey(const Eigen::Vector3f& point, float cell);

 private:
  float cell_;
  std::vector<MaskedPoint> points_;
  std::unordered_map<std::uint64_t, std::size_t> index_;
};

/// A dense grid of masks over a box: in which hypotheses a point is near matter. 0 outside.
class MaskGrid {
 public:
  MaskGrid() = default;

  /// The union of balls of `radius` around the points. `cell` is enlarged where the box would have
  /// more cells than memory and time allow; planar points (all z equal to 0) make a flat grid.
  MaskGrid(const std::vector<MaskedPoint>& points, float radius, float cell);

  HypothesisMask at(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f scaled = (point - min_) * inverse_cell_;
    // The comparisons are false for values that are not numbers.
    if (!(scaled.x() >= 0.0F && scaled.x() < extent_.x() && scaled.y() >= 0.0F &&
          scaled.y() < extent_.y() && scaled.z() >= 0.0F && scaled.z() < extent_.z())) {
      return 0;
    }
    return masks_[(static_cast<int>(scaled.z()) * size_.y() + static_cast<int>(scaled.y())) *
                      size_.x() +
                  static_cast<int>(scaled.x())];
  }

 private:
  void stamp(const MaskedPoint& ball, float radius);

  Eigen::Vector3f min_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f extent_ = Eigen::Vector3f::Zero();  ///< number of cells, as it is compared with
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  float cell_ = 1.0F;
  float inverse_cell_ = 1.0F;
  std::vector<HypothesisMask> masks_;
};

}  // namespace smore
