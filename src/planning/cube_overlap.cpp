// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/cube_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace smore {
namespace {

// Below this the edges are parallel to rounding, and the face axes decide alone.
constexpr double kParallel = 1e-9;

}  // namespace

CubeOverlap::CubeOverlap(const Eigen::Matrix3d& rotation, double edge)
    : edge_(edge), reach_(std::sqrt(3.0) * edge) {
  for (int i = 0; i < 3; ++i) add(Vec3::Unit(i), rotation);
  for (int i = 0; i < 3; ++i) add(rotation.col(i), rotation);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) add(Vec3::Unit(i).cross(rotation.col(j)), rotation);
  }
}

void CubeOverlap::add(const Vec3& axis, const Eigen::Matrix3d& rotation) {
  const double length = axis.norm();
  if (length < kParallel) return;
  const Vec3 unit = axis / length;
  // In planar motion most of the axes are the same.
  for (int i = 0; i < count_; ++i) {
    if (axes_[i].cross(unit).squaredNorm() < kParallel * kParallel) return;
  }
  axes_[count_] = unit;
  radii_[count_] = 0.5 * edge_ * (unit.lpNorm<1>() + (rotation.transpose() * unit).lpNorm<1>());
  ++count_;
}

double CubeOverlap::separation(const Vec3& offset, double enough) const {
  double best = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < count_ && best < enough; ++i) {
    best = std::max(best, std::abs(axes_[i].dot(offset)) - radii_[i]);
  }
  return best;
}

}  // namespace smore
