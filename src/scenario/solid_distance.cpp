// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/solid_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "triangle_tree.h"

namespace smore {
namespace {

struct DistanceInFrame {
  const Vec3& point;
  const TriangleTree* tree;

  double operator()(const BoxShape& box) const {
    const Vec3 beyond = point.cwiseAbs() - box.size / 2.0;
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
  }

  double operator()(const CylinderShape& cylinder) const {
    const double radial = std::hypot(point.x(), point.y()) - cylinder.radius;
    const double axial = std::abs(point.z()) - cylinder.length / 2.0;
    const double outside = std::hypot(std::max(radial, 0.0), std::max(axial, 0.0));
    return outside + std::min(std::max(radial, axial), 0.0);
  }

  double operator()(const SphereShape& sphere) const { return point.norm() - sphere.radius; }

  double operator()(const MeshShape& /*mesh*/) const {
    const double distance = tree->distance(point);
    return tree->windingNumber(point) > 0 ? -distance : distance;
  }
};

}  // namespace

SolidDistance::SolidDistance(const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes) {
    Solid solid;
    solid.T_solid_parent = shape.pose.inverse();
    if (const auto* mesh = std::get_if<MeshShape>(&shape.geometry)) {
      solid.geometry = MeshShape();
      solid.tree = std::make_shared<const TriangleTree>(*mesh);
    } else {
      solid.geometry = shape.geometry;
    }
    solids_.push_back(std::move(solid));
  }
}

double SolidDistance::operator()(const Vec3& point) const {
  double distance = std::numeric_limits<double>::infinity();
  for (const Solid& solid : solids_) {
    const Vec3 local = solid.T_solid_parent * point;
    distance =
        std::min(distance, std::visit(DistanceInFrame{local, solid.tree.get()}, solid.geometry));
  }
  return distance;
}

double signedDistance(const std::vector<Shape>& shapes, const Vec3& point) {
  return SolidDistance(shapes)(point);
}

}  // namespace smore
