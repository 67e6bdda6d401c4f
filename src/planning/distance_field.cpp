// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/distance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace smore {
namespace {

constexpr float kFar = 1e12F;  // squared cells: beyond any grid, yet far from overflow

/// Lower envelope of the parabolas f(q) + (x - q)^2, sampled where they stand.
class ParabolaEnvelope {
 public:
  explicit ParabolaEnvelope(int size) : input_(size), vertices_(size), borders_(size + 1) {}

  std::vector<float>& input() { return input_; }

  /// Writes the envelope with `stride` between neighbours.
  void write(float* output, std::size_t stride) {
    build();
    const int size = static_cast<int>(input_.size());
    for (int x = 0, k = 0; x < size; ++x) {
      while (borders_[k + 1] < static_cast<float>(x)) ++k;
      const float offset = static_cast<float>(x - vertices_[k]);
      output[x * stride] = offset * offset + input_[vertices_[k]];
    }
  }

 private:
  float crossing(int left, int right) const {
    const float square = static_cast<float>(right) * static_cast<float>(right) -
                         static_cast<float>(left) * static_cast<float>(left);
    return (input_[right] - input_[left] + square) / (2.0F * static_cast<float>(right - left));
  }

  void build() {
    const int size = static_cast<int>(input_.size());
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    int k = 0;
    vertices_[0] = 0;
    borders_[0] = -kInfinity;
    borders_[1] = kInfinity;
    for (int q = 1; q < size; ++q) {
      while (k > 0 && crossing(vertices_[k], q) <= borders_[k]) --k;
      borders_[k + 1] = crossing(vertices_[k], q);
      vertices_[++k] = q;
      borders_[k + 1] = kInfinity;
    }
  }

  std::vector<float> input_;
  std::vector<int> vertices_;
  std::vector<float> borders_;
};

int floorDivide(int value, int divisor) {
  return value >= 0 ? value / divisor : -((divisor - 1 - value) / divisor);
}

Eigen::Vector3i cellOf(const VoxelKey& key, int voxels_per_cell) {
  return {floorDivide(key.x, voxels_per_cell), floorDivide(key.y, voxels_per_cell),
          floorDivide(key.z, voxels_per_cell)};
}

}  // namespace

DistanceField::DistanceField(const OccupiedVoxels& voxels) {
  if (voxels.keys.empty()) return;
  chooseCells(voxels);
  markOccupied(voxels);
  for (int axis = 0; axis < 3; ++axis) transformAxis(axis);
  for (float& value : distance_) value = static_cast<float>(cell_) * std::sqrt(value);
}

void DistanceField::chooseCells(const OccupiedVoxels& voxels) {
  centers_ = {Vec3::Constant(std::numeric_limits<double>::infinity()),
              Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (const VoxelKey& key : voxels.keys) {
    const Vec3 center = voxelCenter(key, voxels.voxel_size);
    centers_.min = centers_.min.cwiseMin(center);
    centers_.max = centers_.max.cwiseMax(center);
  }
  const VoxelKey lowest = voxelAt(centers_.min, voxels.voxel_size);
  const VoxelKey highest = voxelAt(centers_.max, voxels.voxel_size);
  for (int width = 1;; width *= 2) {
    first_ = cellOf(lowest, width);
    size_ = cellOf(highest, width) - first_ + Eigen::Vector3i::Ones();
    cell_ = width * voxels.voxel_size;
    slack_ = 0.5 * std::sqrt(3.0) * (cell_ - voxels.voxel_size);
    if (size_.cast<std::size_t>().prod() <= kMaxCells) break;
  }
}

void DistanceField::markOccupied(const OccupiedVoxels& voxels) {
  distance_.assign(size_.cast<std::size_t>().prod(), kFar);
  const int width = static_cast<int>(std::lround(cell_ / voxels.voxel_size));
  for (const VoxelKey& key : voxels.keys) distance_[indexOf(cellOf(key, width) - first_)] = 0.0F;
}

void DistanceField::transformAxis(int axis) {
  const std::array<std::size_t, 3> strides = {
      1, static_cast<std::size_t>(size_.x()),
      static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y())};
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  ParabolaEnvelope envelope(size_[axis]);
  for (int i = 0; i < size_[u]; ++i) {
    for (int j = 0; j < size_[v]; ++j) {
      float* line = distance_.data() + i * strides[u] + j * strides[v];
      for (int k = 0; k < size_[axis]; ++k) envelope.input()[k] = line[k * strides[axis]];
      envelope.write(line, strides[axis]);
    }
  }
}

std::size_t DistanceField::indexOf(const Eigen::Vector3i& cell) const {
  return cell.x() + static_cast<std::size_t>(size_.x()) *
                        (cell.y() + static_cast<std::size_t>(size_.y()) * cell.z());
}

DistanceField::Distance DistanceField::at(const Vec3& point) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (distance_.empty()) return {kInfinity, kInfinity};
  const Vec3 inside = point.cwiseMax(centers_.min).cwiseMin(centers_.max);
  const Eigen::Vector3i cell = (inside / cell_).array().floor().cast<int>() - first_.array();
  const Eigen::Vector3i held =
      cell.cwiseMax(Eigen::Vector3i::Zero()).cwiseMin(size_ - Eigen::Vector3i::Ones());
  const Vec3 center = cell_ * ((held + first_).cast<double>() + Vec3::Constant(0.5));
  const double distance = distance_[indexOf(held)];
  const double off_center = (point - center).norm() + slack_;
  return {std::max(distance - off_center, (point - inside).norm()), distance + off_center};
}

}  // namespace smore
