// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/shape.h"

#include <cmath>
#include <limits>

namespace smore {
namespace {

Bounds symmetricBounds(const Pose& pose, const Vec3& extent) {
  return {pose.translation() - extent, pose.translation() + extent};
}

Bounds boundsInParent(const BoxShape& box, const Pose& pose) {
  return symmetricBounds(pose, pose.linear().cwiseAbs() * box.size / 2.0);
}

// Half extent of a disc with unit normal n along each axis: the radius times sqrt(1 - n^2).
Bounds boundsInParent(const CylinderShape& cylinder, const Pose& pose) {
  const Vec3 axis = pose.linear().col(2);
  const Vec3 disc = (1.0 - axis.array().square()).max(0.0).sqrt() * cylinder.radius;
  return symmetricBounds(pose, axis.cwiseAbs() * cylinder.length / 2.0 + disc);
}

Bounds boundsInParent(const SphereShape& sphere, const Pose& pose) {
  return symmetricBounds(pose, Vec3::Constant(sphere.radius));
}

Bounds boundsInParent(const MeshShape& mesh, const Pose& pose) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds bounds{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const Vec3& vertex : mesh.vertices) {
    bounds.min = bounds.min.cwiseMin(pose * vertex);
    bounds.max = bounds.max.cwiseMax(pose * vertex);
  }
  return bounds;
}

}  // namespace

Bounds boundsOf(const std::vector<Shape>& shapes) {
  if (shapes.empty()) return {};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds bounds{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const Shape& shape : shapes) {
    const auto bounds_of = [&shape](const auto& solid) {
      return boundsInParent(solid, shape.pose);
    };
    const Bounds part = std::visit(bounds_of, shape.geometry);
    bounds.min = bounds.min.cwiseMin(part.min);
    bounds.max = bounds.max.cwiseMax(part.max);
  }
  return bounds;
}

}  // namespace smore
