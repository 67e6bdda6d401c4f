// SPDX-License-Identifier: BSD-3-Clause
#include "triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace smore {
namespace {

using Box = Eigen::AlignedBox3d;
using Triangles = std::vector<TriangleCorners>;

double squaredDistanceToSegment(const Vec3& a, const Vec3& b, const Vec3& point) {
  const Vec3 along = b - a;
  const double length_squared = along.squaredNorm();
  const double t = length_squared > 0.0 ? (point - a).dot(along) / length_squared : 0.0;
  return (a + std::clamp(t, 0.0, 1.0) * along - point).squaredNorm();
}

double squaredDistanceToTriangle(const TriangleCorners& corners, const Vec3& point) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  bool above = normal.squaredNorm() > 0.0;
  double to_edges = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % 3];
    above = above && normal.cross(b - a).dot(point - a) >= 0.0;
    to_edges = std::min(to_edges, squaredDistanceToSegment(a, b, point));
  }
  if (!above) return to_edges;
  const double height = normal.dot(point - corners[0]);
  return height * height / normal.squaredNorm();
}

// The members of the next three are named as Eigen's tree calls them.
struct NearestTriangle {
  using Scalar = double;
  const Triangles* triangles;
  Vec3 point;

  double minimumOnVolume(const Box& box) const { return box.squaredExteriorDistance(point); }
  double minimumOnObject(int i) const {
    return squaredDistanceToTriangle((*triangles)[static_cast<std::size_t>(i)], point);
  }
};

struct AnyBeyond {
  const Triangles* triangles;
  Vec3 direction;
  double height;
  bool* found;

  bool intersectVolume(const Box& box) const {
    return (direction.array() > 0.0).select(box.max(), box.min()).dot(direction) > height;
  }
  bool intersectObject(int i) const {
    const TriangleCorners& corners = (*triangles)[static_cast<std::size_t>(i)];
    *found = std::any_of(corners.begin(), corners.end(),
                         [&](const Vec3& corner) { return corner.dot(direction) > height; });
    return *found;  // ends the search
  }
};

// Counts the triangles that a ray leaves through, less those that it enters through. The edges'
// sides are computed alike, but for the sign, for the two triangles that share an edge: none is
// missed and none counted twice.
struct RayCrossings {
  const Triangles* triangles;
  Vec3 origin;
  Vec3 direction;
  int winding = 0;

  bool intersectVolume(const Box& box) const {
    double enter = 0.0;
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.min()[axis] - origin[axis]) / direction[axis];
      const double b = (box.max()[axis] - origin[axis]) / direction[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave * (1.0 + 1e-12);  // rounding must not lose a box
  }

  bool intersectObject(int i) {
    const TriangleCorners& corners = (*triangles)[static_cast<std::size_t>(i)];
    const std::array<Vec3, 3> seen = {corners[0] - origin, corners[1] - origin,
                                      corners[2] - origin};
    int left = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double side = direction.dot(seen[k].cross(seen[(k + 1) % 3]));
      left += side > 0.0 ? 1 : side < 0.0 ? -1 : 0;
    }
    if (std::abs(left) != 3) return false;
    // The ray's line passes through; it is before the origin where the volume's sign differs.
    const double volume = seen[0].dot(seen[1].cross(seen[2]));
    if (volume * left > 0.0) winding += left > 0 ? 1 : -1;
    return false;  // go on
  }
};

// No surface that somebody draws lies along these.
const Vec3 kRayDirection = Vec3(0.5773, 0.6180, 0.5338).normalized();

}  // namespace

TriangleCorners cornersOf(const MeshShape& mesh, const Eigen::Vector3i& triangle) {
  TriangleCorners corners;
  for (int i = 0; i < 3; ++i) {
    corners[static_cast<std::size_t>(i)] = mesh.vertices[static_cast<std::size_t>(triangle[i])];
  }
  return corners;
}

Vec3 areaVector(const TriangleCorners& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

double signedVolume(const TriangleCorners& corners) {
  return corners[0].dot(corners[1].cross(corners[2])) / 6.0;
}

TriangleTree::TriangleTree(const MeshShape& mesh) {
  std::vector<Box> boxes;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    corners_.push_back(cornersOf(mesh, triangle));
    Box box(corners_.back()[0]);
    boxes.push_back(box.extend(corners_.back()[1]).extend(corners_.back()[2]));
  }
  std::vector<int> indices(corners_.size());
  std::iota(indices.begin(), indices.end(), 0);
  tree_.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
}

double TriangleTree::distance(const Vec3& point) const {
  NearestTriangle nearest{&corners_, point};
  return std::sqrt(Eigen::BVMinimize(tree_, nearest));
}

int TriangleTree::windingNumber(const Vec3& point) const {
  RayCrossings crossings{&corners_, point, kRayDirection};
  Eigen::BVIntersect(tree_, crossings);
  return crossings.winding;
}

bool TriangleTree::reachesBeyond(const Vec3& direction, double height) const {
  bool found = false;
  AnyBeyond any{&corners_, direction, height, &found};
  Eigen::BVIntersect(tree_, any);
  return found;
}

}  // namespace smore
