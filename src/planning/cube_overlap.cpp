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
    : reach_(std::sqrt(3.0) * edge) {
  const auto add = [&](const Vec3& axis) {
    const double length = axis.norm();
    if (length < kParallel) return;
    axes_[count_] = axis / length;
    radii_[count_] =
        0.5 * edge *
        (axes_[count_].lpNorm<1>() + (rotation.transpose() * axes_[count_]).lpNorm<1>());
    ++count_;
  };
  for (int i = 0; i < 3; ++i) add(Vec3::Unit(i));
  for (int i = 0; i < 3; ++i) add(rotation.col(i));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) add(Vec3::Unit(i).cross(rotation.col(j)));
  }
}

double CubeOverlap::separation(const Vec3& offset) const {
  double best = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < count_; ++i)
    best = std::max(best, std::abs(axes_[i].dot(offset)) - radii_[i]);
  return best;
}

bool CubeOverlap::isCloserThan(const Vec3& offset, double limit) const {
  for (int i = 0; i < count_; ++i) {
    if (std::abs(axes_[i].dot(offset)) - radii_[i] > limit) return false;
  }
  return true;
}

}  // namespace smore
