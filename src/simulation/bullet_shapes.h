// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <btBulletCollisionCommon.h>

#include <memory>
#include <vector>

#include "smore/scenario/shape.h"

namespace smore {

btVector3 toBullet(const Vec3& vector);
Vec3 fromBullet(const btVector3& vector);
btTransform toBullet(const Pose& pose);
Pose fromBullet(const btTransform& transform);

/// A shape of Bullet with the data that it refers to.
struct BulletShape {
  std::unique_ptr<btTriangleMesh> triangles;  ///< of a static triangle mesh only
  std::unique_ptr<btCollisionShape> shape;
};

/// The solid in Bullet, in its own frame. Boxes, cylinders, spheres and meshes that serve as their
/// hull are solids; another mesh becomes its surface and may only stand still.
BulletShape makeBulletShape(const Shape& shape);

/// The same as convex solids in its frame: the parts of a mesh that has such, else the solid alone.
std::vector<BulletShape> makeConvexShapes(const Shape& shape);

/// Solids that stand still.
class BulletSolids {
 public:
  /// The poses of `shapes` are those in the Bullet world.
  explicit BulletSolids(const std::vector<Shape>& shapes);

  const std::vector<std::unique_ptr<btCollisionObject>>& solids() const { return solids_; }

 private:
  std::vector<BulletShape> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> solids_;
};

/// One moving body of convex parts.
class BulletCompound {
 public:
  /// `T_body_parent` is the shapes' parent frame in the body's frame.
  BulletCompound(const std::vector<Shape>& shapes, const Pose& T_body_parent);

  btCompoundShape* shape() { return compound_.get(); }

  /// Which of the shapes a child of the compound, by its index in contact points, is a part of.
  std::size_t shapeOf(int child) const {
    return shape_of_child_.at(static_cast<std::size_t>(child));
  }

 private:
  std::vector<BulletShape> parts_;
  std::vector<std::size_t> shape_of_child_;
  std::unique_ptr<btCompoundShape> compound_;
};

}  // namespace smore
