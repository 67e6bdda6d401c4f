// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/mask_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "smore/common/parallel_for.h"
#include "smore/common/wide_vectors.h"

namespace smore {
namespace {

constexpr double kMostCells = 4e6;  // 32 MB

constexpr float kRounding = 1e-3F;  // of squared distances in cells

constexpr int kSlab = 16;  // planes of a grid that are widened by one thread

// One more than the span holds: the box begins half a cell lower.
unsigned cellsOver(float span, float cell) {
  return static_cast<unsigned>(std::ceil(span / cell)) + 1;
}

SMORE_WIDE_VECTORS void unite(const HypothesisMask* source, unsigned count,
                              HypothesisMask* destination) {
  for (unsigned i = 0; i < count; ++i) destination[i] |= source[i];
}

// Adds to `widened` what is in the cells `distance` away on both sides.
void widen(const HypothesisMask* row, unsigned distance, std::vector<HypothesisMask>* widened) {
  const auto width = static_cast<unsigned>(widened->size());
  if (distance >= width) return;
  if (distance == 0) widened->assign(row, row + width);
  unite(row + distance, width - distance, widened->data());
  unite(row, width - distance, widened->data() + distance);
}

}  // namespace

// Cells along x of a ball around a cell, from -half_length to half_length.
struct MaskGrid::BallRow {
  int y;
  int z;
  int half_length;
};

// The shortest rows first.
std::vector<MaskGrid::BallRow> MaskGrid::rowsOfBall(float radius) {
  const int reach = static_cast<int>(std::ceil(radius)) - 1;
  std::vector<BallRow> rows;
  for (int z = -reach; z <= reach; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      const float left = radius * radius - static_cast<float>(z * z + y * y);
      if (left > kRounding) rows.push_back({y, z, static_cast<int>(std::sqrt(left - kRounding))});
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const BallRow& a, const BallRow& b) {
    return a.half_length < b.half_length;
  });
  return rows;
}

Eigen::AlignedBox3f boxAround(const std::vector<MaskedPoint>& points, float margin, bool planar) {
  Eigen::AlignedBox3f box;
  for (const MaskedPoint& point : points) box.extend(point.point);
  const Eigen::Vector3f margins(margin, margin, planar ? 0.0F : margin);
  return {box.min() - margins, box.max() + margins};
}

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

MaskGrid::MaskGrid(const Eigen::AlignedBox3f& box, float cell) : cell_(cell) {
  if (box.isEmpty()) return;
  const Eigen::Vector3f span = box.sizes();
  const auto count_cells = [&] {
    width_ = cellsOver(span.x(), cell_);
    depth_ = cellsOver(span.y(), cell_);
    height_ = cellsOver(span.z(), cell_);
    return static_cast<double>(width_) * depth_ * height_;
  };
  while (count_cells() > kMostCells) cell_ *= 2.0F;
  // Half a cell lower on each axis: points on the edge fall inside, and z = 0 into the middle.
  min_ = box.min() - Eigen::Vector3f::Constant(0.5F * cell_);
  inverse_cell_ = 1.0F / cell_;
  masks_.assign(static_cast<std::size_t>(width_) * depth_ * height_, 0);
}

MaskGrid::MaskGrid(const std::vector<MaskedPoint>& points, float radius, float cell, bool planar) {
  if (points.empty()) return;
  // A margin of whole cells: points on a lattice of some cells then lie in the middle of cells.
  *this = MaskGrid(boxAround(points, std::ceil(radius / cell) * cell, planar), cell);
  for (const MaskedPoint& ball : points) mark(ball.point, ball.mask);
  dilate(radius);
}

// Slab by slab, each of some planes of the result: slabs do not depend on one another.
void MaskGrid::dilate(float radius) {
  const std::vector<HypothesisMask> marked = std::move(masks_);
  masks_.assign(marked.size(), 0);
  const std::vector<BallRow> ball = rowsOfBall(radius * inverse_cell_);
  parallelFor((height_ + kSlab - 1) / kSlab, [&](std::size_t slab) {
    const int first = static_cast<int>(slab) * kSlab;
    addBalls(marked, ball, first, std::min(first + kSlab, static_cast<int>(height_)));
  });
}

// To the planes from `first` to before `end`. A ball is rows along x, each of its own half length:
// a row of cells is widened once for each of these lengths.
void MaskGrid::addBalls(const std::vector<HypothesisMask>& marked, const std::vector<BallRow>& ball,
                        int first, int end) {
  const int reach = ball.empty() ? 0 : ball.back().half_length;
  std::vector<HypothesisMask> widened(width_);
  for (int z = std::max(0, first - reach); z < std::min(static_cast<int>(height_), end + reach);
       ++z) {
    for (int y = 0; y < static_cast<int>(depth_); ++y) {
      const HypothesisMask* row = &marked[(z * depth_ + y) * width_];
      if (std::all_of(row, row + width_, [](HypothesisMask mask) { return mask == 0; })) continue;
      int half_length = -1;
      for (const BallRow& of_ball : ball) {
        for (; half_length < of_ball.half_length; ++half_length) {
          widen(row, half_length + 1, &widened);
        }
        const int to_z = z + of_ball.z;
        const auto to_y = static_cast<unsigned>(y + of_ball.y);
        if (to_z < first || to_z >= end || to_y >= depth_) continue;
        unite(widened.data(), width_, &masks_[(to_z * depth_ + to_y) * width_]);
      }
    }
  }
}

}  // namespace smore
