// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/mass_properties.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace smore {
namespace {

// Inertia about a point at `offset` from the centre of mass, less that about the centre of mass.
Eigen::Matrix3d parallelAxis(double mass, const Vec3& offset) {
  return -mass * crossMatrix(offset) * crossMatrix(offset);
}

Eigen::Matrix3d diagonal(double x, double y, double z) { return Vec3(x, y, z).asDiagonal(); }

// Mass properties at unit density, in the solid's own frame.
MassProperties unitDensity(const BoxShape& box) {
  const double mass = box.size.prod();
  const Vec3 s = box.size.cwiseAbs2() * mass / 12.0;
  return {mass, Vec3::Zero(), diagonal(s.y() + s.z(), s.z() + s.x(), s.x() + s.y())};
}

MassProperties unitDensity(const CylinderShape& cylinder) {
  const double radius_squared = cylinder.radius * cylinder.radius;
  const double mass = M_PI * radius_squared * cylinder.length;
  const double across = mass * (3.0 * radius_squared + cylinder.length * cylinder.length) / 12.0;
  return {mass, Vec3::Zero(), diagonal(across, across, mass * radius_squared / 2.0)};
}

MassProperties unitDensity(const SphereShape& sphere) {
  const double mass = 4.0 / 3.0 * M_PI * std::pow(sphere.radius, 3);
  const double inertia = 0.4 * mass * sphere.radius * sphere.radius;
  return {mass, Vec3::Zero(), diagonal(inertia, inertia, inertia)};
}

// Sum over the tetrahedra from the origin to each triangle. The second moment of a tetrahedron with
// corners 0, a, b, c and volume V is V/20 (aa' + bb' + cc' + ss') with s = a + b + c.
MassProperties unitDensity(const MeshShape& mesh) {
  double mass = 0.0;
  Vec3 first_moment = Vec3::Zero();
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const Vec3& a = mesh.vertices[static_cast<size_t>(triangle[0])];
    const Vec3& b = mesh.vertices[static_cast<size_t>(triangle[1])];
    const Vec3& c = mesh.vertices[static_cast<size_t>(triangle[2])];
    const Vec3 sum = a + b + c;
    const double volume = a.dot(b.cross(c)) / 6.0;
    mass += volume;
    first_moment += volume / 4.0 * sum;
    second_moment +=
        volume / 20.0 *
        (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  const Vec3 center = first_moment / mass;
  const Eigen::Matrix3d about_origin =
      second_moment.trace() * Eigen::Matrix3d::Identity() - second_moment;
  return {mass, center, about_origin - parallelAxis(mass, center)};
}

MassProperties inParent(const Shape& shape) {
  const auto unit_density = [](const auto& solid) { return unitDensity(solid); };
  return transformMass(shape.pose, std::visit(unit_density, shape.geometry));
}

}  // namespace

MassProperties massProperties(const std::vector<Shape>& shapes, double mass) {
  std::vector<MassProperties> parts;
  parts.reserve(shapes.size());
  for (const Shape& shape : shapes) parts.push_back(inParent(shape));
  MassProperties body = joined(parts);
  body.inertia *= mass / body.mass;
  body.mass = mass;
  return body;
}

MassProperties transformMass(const Pose& T_a_b, const MassProperties& body_b) {
  MassProperties body = body_b;
  body.center = T_a_b * body_b.center;
  body.inertia = T_a_b.linear() * body_b.inertia * T_a_b.linear().transpose();
  return body;
}

MassProperties joined(const std::vector<MassProperties>& bodies) {
  MassProperties whole;
  for (const MassProperties& body : bodies) {
    whole.mass += body.mass;
    whole.center += body.mass * body.center;
  }
  if (whole.mass == 0.0) return {};
  whole.center /= whole.mass;
  for (const MassProperties& body : bodies) {
    whole.inertia += body.inertia + parallelAxis(body.mass, body.center - whole.center);
  }
  return whole;
}

Pose principalFrame(const MassProperties& body) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(body.inertia);
  Pose frame = Pose::Identity();
  frame.linear() = axes.eigenvectors();
  if (frame.linear().determinant() < 0.0) frame.linear().col(0) *= -1.0;
  frame.translation() = body.center;
  return frame;
}

Eigen::Matrix<double, 6, 6> spatialInertia(const MassProperties& body) {
  const Eigen::Matrix3d lever = body.mass * crossMatrix(body.center);
  Eigen::Matrix<double, 6, 6> inertia;
  inertia << body.mass * Eigen::Matrix3d::Identity(), -lever, lever,
      body.inertia + parallelAxis(body.mass, body.center);
  return inertia;
}

}  // namespace smore
