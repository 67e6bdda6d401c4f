// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "smore/scenario/mesh.h"

namespace smore {
namespace {

double distanceInFrame(const BoxShape& box, const Vec3& point) {
  const Vec3 beyond = point.cwiseAbs() - box.size / 2.0;
  return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

double distanceInFrame(const CylinderShape& cylinder, const Vec3& point) {
  const double radial = std::hypot(point.x(), point.y()) - cylinder.radius;
  const double axial = std::abs(point.z()) - cylinder.length / 2.0;
  const double outside = std::hypot(std::max(radial, 0.0), std::max(axial, 0.0));
  return outside + std::min(std::max(radial, axial), 0.0);
}

double distanceInFrame(const SphereShape& sphere, const Vec3& point) {
  return point.norm() - sphere.radius;
}

double distanceInFrame(const MeshShape& mesh, const Vec3& point) {
  return signedDistance(mesh, point);
}

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

double signedDistance(const std::vector<Shape>& shapes, const Vec3& point) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Shape& shape : shapes) {
    const Vec3 local = shape.pose.inverse() * point;
    const auto distance_to = [&local](const auto& solid) { return distanceInFrame(solid, local); };
    distance = std::min(distance, std::visit(distance_to, shape.geometry));
  }
  return distance;
}

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
