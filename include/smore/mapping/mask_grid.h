// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace smore {

/// One bit for each sampled explanation of the evidence.
using HypothesisMask = std::uint64_t;
constexpr int kHypotheses = 64;

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

/// A box that holds the points with `margin` [m] to spare, empty without points; a flat one for the
/// points of `planar` motion.
Eigen::AlignedBox3f boxAround(const std::vector<MaskedPoint>& points, float margin, bool planar);

/// A dense grid of masks over a box: in which hypotheses a point is near matter. 0 outside.
class MaskGrid {
 public:
  MaskGrid() = default;

  /// No matter yet, over `box`. `cell` is doubled where the box would have more cells than memory
  /// and time allow, and again; a box that is flat at z = 0 makes a flat grid, an empty box one
  /// without cells.
  MaskGrid(const Eigen::AlignedBox3f& box, float cell);

  /// The union of balls of `radius` around the cells that hold the points; of discs in the plane of
  /// `planar` motion.
  MaskGrid(const std::vector<MaskedPoint>& points, float radius, float cell, bool planar);

  /// Matter at all points in one cell; nothing happens outside of the box.
  void mark(const Eigen::Vector3f& point, HypothesisMask mask) {
    const std::size_t cell = indexOf(point);
    if (cell < masks_.size()) masks_[cell] |= mask;
  }

  /// Turns each marked cell into a ball of `radius` around its centre.
  void dilate(float radius);

  HypothesisMask at(const Eigen::Vector3f& point) const {
    const std::size_t cell = indexOf(point);
    return cell < masks_.size() ? masks_[cell] : 0;
  }

 private:
  /// Of the cell that holds the point; too large outside of the box, and for values that are not
  /// numbers.
  std::size_t indexOf(const Eigen::Vector3f& point) const {
    const auto x = static_cast<unsigned>(static_cast<int>((point.x() - min_.x()) * inverse_cell_));
    const auto y = static_cast<unsigned>(static_cast<int>((point.y() - min_.y()) * inverse_cell_));
    const auto z = static_cast<unsigned>(static_cast<int>((point.z() - min_.z()) * inverse_cell_));
    if (x >= width_ || y >= depth_ || z >= height_) return masks_.size();
    return (z * depth_ + y) * width_ + x;
  }
  struct BallRow;
  static std::vector<BallRow> rowsOfBall(float radius);
  void addBalls(const std::vector<HypothesisMask>& marked, const std::vector<BallRow>& ball,
                int first, int end);

  Eigen::Vector3f min_ = Eigen::Vector3f::Zero();
  unsigned width_ = 0;  ///< cells along x, y and z
  unsigned depth_ = 0;
  unsigned height_ = 0;
  float cell_ = 1.0F;
  float inverse_cell_ = 1.0F;
  std::vector<HypothesisMask> masks_;
};

}  // namespace smore
