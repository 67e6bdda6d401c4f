// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

struct BoxShape {
  Vec3 size = Vec3::Ones();  ///< full edge lengths [m], positive
};

/// Its axis is z, its centre the origin.
struct CylinderShape {
  double radius = 1.0;  ///< [m], positive
  double length = 1.0;  ///< [m], positive
};

struct SphereShape {
  double radius = 1.0;  ///< [m], positive
};

/// A convex solid by the surface of its hull [m].
struct ConvexPart {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;  ///< indices into vertices
};

/// A closed triangle mesh, already scaled [m].
struct MeshShape {
  std::string file;
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i>
      triangles;              ///< indices into vertices, counter-clockwise from outside
  Vec3 scale = Vec3::Ones();  ///< what the file's coordinates were multiplied by
  /// Of a concave mesh that moves: solids whose union stands for it where bodies collide.
  std::vector<ConvexPart> parts;
  double parts_error = 0.0;  ///< how far the surfaces of mesh and union are apart, at most [m]
};

/// One solid of the object or the environment.
struct Shape {
  std::variant<BoxShape, CylinderShape, SphereShape, MeshShape> geometry;
  Pose pose = Pose::Identity();  ///< of the solid in its parent frame (object or world)
};

/// SolidDistance for a single point.
double signedDistance(const std::vector<Shape>& shapes, const Vec3& point);

/// Smallest axis-aligned box around the shapes, in their parent frame.
Bounds boundsOf(const std::vector<Shape>& shapes);

}  // namespace smore
