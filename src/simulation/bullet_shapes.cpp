// SPDX-License-Identifier: BSD-3-Clause
#include "bullet_shapes.h"

#include <algorithm>

#include "smore/scenario/mesh.h"

namespace smore {
namespace {

// Bullet rounds shapes by a collision margin, 4 cm unless told. Boxes and cylinders keep their size
// and lose their sharp edges within it; hulls grow by it, so that theirs is a tenth of a
// millimetre.
constexpr double kMargin = 1e-3;
constexpr double kHullMargin = 1e-4;

// Contact points are kept while they are nearer than this and predicted from this distance on [m].
// Bullet's 2 cm (or 2 % of the shape) would keep points that have slid away by as much.
constexpr double kContactBreakingDistance = 1e-3;

class PreciseCompound : public btCompoundShape {
 public:
  btScalar getContactBreakingThreshold(btScalar /*default_factor*/) const override {
    return kContactBreakingDistance;
  }
};

// The margin is a part of the shape's size: never more than half of it.
double marginFor(double half_extent) { return std::min(kMargin, 0.5 * half_extent); }

BulletShape make(const BoxShape& box) {
  auto shape = std::make_unique<btBoxShape>(toBullet(Vec3(box.size / 2.0)));
  shape->setMargin(marginFor(box.size.minCoeff() / 2.0));
  return {nullptr, std::move(shape)};
}

BulletShape make(const CylinderShape& cylinder) {
  const double half_length = cylinder.length / 2.0;
  const btVector3 half_extents(cylinder.radius, cylinder.radius, half_length);
  auto shape = std::make_unique<btCylinderShapeZ>(half_extents);
  shape->setMargin(marginFor(std::min(cylinder.radius, half_length)));
  return {nullptr, std::move(shape)};
}

BulletShape make(const SphereShape& sphere) {
  return {nullptr, std::make_unique<btSphereShape>(sphere.radius)};
}

BulletShape makeHull(const std::vector<Vec3>& vertices) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vec3& vertex : vertices) shape->addPoint(toBullet(vertex), false);
  shape->recalcLocalAabb();
  shape->setMargin(kHullMargin);
  return {nullptr, std::move(shape)};
}

BulletShape makeSurface(const MeshShape& mesh) {
  auto triangles = std::make_unique<btTriangleMesh>();
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const auto vertex = [&](int i) {
      return toBullet(mesh.vertices[static_cast<size_t>(triangle[i])]);
    };
    triangles->addTriangle(vertex(0), vertex(1), vertex(2));
  }
  auto shape = std::make_unique<btBvhTriangleMeshShape>(triangles.get(), true);
  shape->setMargin(kHullMargin);
  return {std::move(triangles), std::move(shape)};
}

BulletShape make(const MeshShape& mesh) {
  return servesAsHull(mesh) ? makeHull(mesh.vertices) : makeSurface(mesh);
}

}  // namespace

btVector3 toBullet(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Vec3 fromBullet(const btVector3& vector) { return {vector.x(), vector.y(), vector.z()}; }

btTransform toBullet(const Pose& pose) {
  const Eigen::Matrix3d& r = pose.linear();
  const btMatrix3x3 basis(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1),
                          r(2, 2));
  return btTransform(basis, toBullet(Vec3(pose.translation())));
}

Pose fromBullet(const btTransform& transform) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    pose.linear().row(row) = fromBullet(transform.getBasis().getRow(row)).transpose();
  }
  pose.translation() = fromBullet(transform.getOrigin());
  return pose;
}

BulletShape makeBulletShape(const Shape& shape) {
  return std::visit([](const auto& solid) { return make(solid); }, shape.geometry);
}

std::vector<BulletShape> makeConvexShapes(const Shape& shape) {
  std::vector<BulletShape> shapes;
  const auto* mesh = std::get_if<MeshShape>(&shape.geometry);
  if (mesh == nullptr || mesh->parts.empty()) {
    shapes.push_back(makeBulletShape(shape));
    return shapes;
  }
  for (const ConvexPart& part : mesh->parts) shapes.push_back(makeHull(part.vertices));
  return shapes;
}

BulletSolids::BulletSolids(const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes) {
    shapes_.push_back(makeBulletShape(shape));
    solids_.push_back(std::make_unique<btCollisionObject>());
    solids_.back()->setCollisionShape(shapes_.back().shape.get());
    solids_.back()->setWorldTransform(toBullet(shape.pose));
  }
}

BulletCompound::BulletCompound(const std::vector<Shape>& shapes, const Pose& T_body_parent)
    : compound_(std::make_unique<PreciseCompound>()) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (BulletShape& part : makeConvexShapes(shapes[i])) {
      parts_.push_back(std::move(part));
      shape_of_child_.push_back(i);
      compound_->addChildShape(toBullet(Pose(T_body_parent * shapes[i].pose)),
                               parts_.back().shape.get());
    }
  }
}

}  // namespace smore
