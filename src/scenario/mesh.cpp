// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "mesh_file.h"
#include "smore/common/result.h"

namespace smore {
namespace {

struct ByCoordinates {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  }
};

// Triangles of which two corners coincide enclose nothing and are left out.
MeshShape mergeVertices(const TriangleSoup& triangles, const Vec3& scale, const std::string& file) {
  MeshShape mesh;
  mesh.file = file;
  std::map<Vec3, int, ByCoordinates> indices;
  for (const auto& triangle : triangles) {
    Eigen::Vector3i corners;
    for (int i = 0; i < 3; ++i) {
      const Vec3 vertex = triangle[static_cast<size_t>(i)].cwiseProduct(scale);
      if (!vertex.allFinite()) throw InputError(file + ": a vertex is not finite; repair the mesh");
      const auto entry = indices.emplace(vertex, static_cast<int>(mesh.vertices.size()));
      if (entry.second) mesh.vertices.push_back(vertex);
      corners[i] = entry.first->second;
    }
    const bool degenerate =
        corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
    if (!degenerate) mesh.triangles.push_back(corners);
  }
  return mesh;
}

// Closed and consistently turned: each directed edge stands once, and so does its opposite.
bool isClosed(const MeshShape& mesh) {
  std::set<std::pair<int, int>> edges;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      if (!edges.emplace(triangle[i], triangle[(i + 1) % 3]).second) return false;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [&edges](const std::pair<int, int>& edge) {
    return edges.count({edge.second, edge.first}) > 0;
  });
}

double meshSize(const MeshShape& mesh) {
  Vec3 min = mesh.vertices.front();
  Vec3 max = min;
  for (const Vec3& vertex : mesh.vertices) {
    min = min.cwiseMin(vertex);
    max = max.cwiseMax(vertex);
  }
  return (max - min).norm();
}

double distanceToSegment(const Vec3& a, const Vec3& b, const Vec3& point) {
  const Vec3 along = b - a;
  const double length_squared = along.squaredNorm();
  const double t = length_squared > 0.0 ? (point - a).dot(along) / length_squared : 0.0;
  return (a + std::clamp(t, 0.0, 1.0) * along - point).norm();
}

double distanceToTriangle(const std::array<Vec3, 3>& corners, const Vec3& point) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  bool above = normal.squaredNorm() > 0.0;
  double edge_distance = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < 3; ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % 3];
    above = above && normal.cross(b - a).dot(point - a) >= 0.0;
    edge_distance = std::min(edge_distance, distanceToSegment(a, b, point));
  }
  return above ? std::abs(normal.normalized().dot(point - corners[0])) : edge_distance;
}

// Solid angle of a triangle seen from `point` (Van Oosterom and Strackee, 1983).
double solidAngle(const std::array<Vec3, 3>& corners, const Vec3& point) {
  const Vec3 a = corners[0] - point;
  const Vec3 b = corners[1] - point;
  const Vec3 c = corners[2] - point;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2.0 * std::atan2(a.dot(b.cross(c)), denominator);
}

std::array<Vec3, 3> cornersOf(const MeshShape& mesh, const Eigen::Vector3i& triangle) {
  std::array<Vec3, 3> corners;
  for (int i = 0; i < 3; ++i) {
    corners[static_cast<size_t>(i)] = mesh.vertices[static_cast<size_t>(triangle[i])];
  }
  return corners;
}

}  // namespace

MeshShape loadMesh(const std::string& file, const Vec3& scale) {
  MeshShape mesh = mergeVertices(readTriangles(file), scale, file);
  if (mesh.triangles.empty()) throw InputError(file + ": no triangles; export the mesh anew");
  if (!isClosed(mesh)) {
    throw InputError(file + ": the surface is not closed or its triangles are turned both ways; " +
                     "close its holes and make its normals consistent");
  }
  const double volume = signedVolume(mesh);
  constexpr double kFlat = 1e-9;  // of the cube of the mesh's size: less is rounding
  if (std::abs(volume) < kFlat * std::pow(meshSize(mesh), 3)) {
    throw InputError(file + ": the mesh encloses no volume; export a solid");
  }
  if (volume < 0.0) {
    for (Eigen::Vector3i& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

double signedVolume(const MeshShape& mesh) {
  double volume = 0.0;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const std::array<Vec3, 3> corners = cornersOf(mesh, triangle);
    volume += corners[0].dot(corners[1].cross(corners[2])) / 6.0;
  }
  return volume;
}

bool isConvex(const MeshShape& mesh) {
  constexpr double kRelativeTolerance = 1e-6;
  const double tolerance = kRelativeTolerance * meshSize(mesh);
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const std::array<Vec3, 3> corners = cornersOf(mesh, triangle);
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (const Vec3& vertex : mesh.vertices) {
      if (normal.dot(vertex - corners[0]) > tolerance) return false;
    }
  }
  return true;
}

double signedDistance(const MeshShape& mesh, const Vec3& point) {
  double distance = std::numeric_limits<double>::infinity();
  double angle = 0.0;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const std::array<Vec3, 3> corners = cornersOf(mesh, triangle);
    distance = std::min(distance, distanceToTriangle(corners, point));
    angle += solidAngle(corners, point);
  }
  const bool inside = angle > 2.0 * M_PI;  // 4 pi inside, 0 outside
  return inside ? -distance : distance;
}

}  // namespace smore
