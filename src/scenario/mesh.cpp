// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/mesh.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "mesh_file.h"
#include "mesh_pieces.h"
#include "smore/common/result.h"
#include "triangle_tree.h"

namespace smore {
namespace {

Vec3 extentOf(const MeshShape& mesh) {
  const Bounds bounds = boundsOf({{mesh, Pose::Identity()}});
  return bounds.max - bounds.min;
}

MeshShape scaled(MeshFile content, const Vec3& scale, const std::string& file) {
  MeshShape mesh;
  mesh.file = file;
  mesh.scale = scale;
  mesh.vertices = std::move(content.vertices);
  mesh.triangles = std::move(content.triangles);
  for (Vec3& vertex : mesh.vertices) {
    vertex = vertex.cwiseProduct(scale).eval();
    if (!vertex.allFinite()) throw InputError(file + ": a vertex is not finite; repair the mesh");
  }
  return mesh;
}

void checkSize(const MeshShape& mesh, const Vec3& scale, double largest, const std::string& file) {
  const double size = extentOf(mesh).maxCoeff();
  std::ostringstream problem;
  if (size > largest) {
    const Vec3 try_this = scale / 1000.0;
    problem << file << ": " << size << " m large, above " << largest
            << " m; looks like millimetres; scale: [" << try_this.x() << ", " << try_this.y()
            << ", " << try_this.z() << "]";
    throw InputError(problem.str());
  }
  const Bounds bounds = boundsOf({{mesh, Pose::Identity()}});
  const double far = bounds.min.cwiseAbs().cwiseMax(bounds.max.cwiseAbs()).maxCoeff();
  if (far > largest) {
    problem << file << ": lies " << far << " m from its own origin, beyond " << largest
            << " m; move it there in the program that made it";
    throw InputError(problem.str());
  }
}

// Closed and consistently turned: each directed edge stands as often as its opposite.
bool isClosed(const MeshShape& mesh) {
  std::vector<std::pair<int, int>> edges;
  std::vector<std::pair<int, int>> opposites;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      edges.emplace_back(triangle[i], triangle[(i + 1) % 3]);
      opposites.emplace_back(triangle[(i + 1) % 3], triangle[i]);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(opposites.begin(), opposites.end());
  return edges == opposites;
}

/// Tells of each triangle whether its centroid is near the convex hull.
class HullDepth {
 public:
  HullDepth(const MeshShape& mesh, double enough)
      : mesh_(mesh), enough_(enough), tree_(mesh), around_(neighbours(mesh)) {}

  // Each direction bounds the depth from above; the normals of the triangle and of those around it
  // give the depth itself where the mesh is convex. Those around it serve where a sliver's own
  // normal is mere rounding.
  bool isShallow(const Eigen::Vector3i& triangle) const {
    const TriangleCorners corners = cornersOf(mesh_, triangle);
    const Vec3 centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
    if (isShallowAlong(areaVector(corners), centroid)) return true;
    for (int corner = 0; corner < 3; ++corner) {
      for (const int other : around_[static_cast<std::size_t>(triangle[corner])]) {
        const auto& neighbour = mesh_.triangles[static_cast<std::size_t>(other)];
        if (isShallowAlong(areaVector(cornersOf(mesh_, neighbour)), centroid)) return true;
      }
    }
    return false;
  }

 private:
  static std::vector<std::vector<int>> neighbours(const MeshShape& mesh) {
    std::vector<std::vector<int>> around(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (int corner = 0; corner < 3; ++corner) {
        const int vertex = mesh.triangles[i][corner];
        around[static_cast<std::size_t>(vertex)].push_back(static_cast<int>(i));
      }
    }
    return around;
  }

  bool isShallowAlong(const Vec3& direction, const Vec3& point) const {
    const double length = direction.norm();
    if (length == 0.0) return false;
    const Vec3 unit = direction / length;
    return !tree_.reachesBeyond(unit, unit.dot(point) + enough_);
  }

  const MeshShape& mesh_;
  double enough_;  ///< what is not deeper is near [m]
  TriangleTree tree_;
  std::vector<std::vector<int>> around_;  ///< triangles at each vertex
};

}  // namespace

MeshShape loadMesh(const std::string& file, const Vec3& scale, double largest) {
  MeshShape mesh = scaled(readMeshFile(file), scale, file);
  if (mesh.triangles.empty()) throw InputError(file + ": no triangles; export the mesh anew");
  checkSize(mesh, scale, largest, file);
  if (!isClosed(mesh)) {
    throw InputError(file + ": the surface is not closed or its triangles are turned both ways; " +
                     "close its holes and make its normals consistent");
  }
  const double volume = signedVolume(mesh);
  constexpr double kFlat = 1e-9;  // of the cube of the mesh's size: less is rounding
  const double least = kFlat * std::pow(extentOf(mesh).norm(), 3);
  if (std::abs(volume) < least) {
    throw InputError(file + ": the mesh encloses no volume; export a solid");
  }
  if (volume < 0.0) {
    for (Eigen::Vector3i& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  if (const auto vertex = pieceInsideOut(mesh, least)) {
    std::ostringstream problem;
    problem << file << ": the piece with a vertex at (" << vertex->x() << ", " << vertex->y()
            << ", " << vertex->z()
            << ") m is turned the other way than the rest: one of them is inside "
            << "out; make all normals point outwards";
    throw InputError(problem.str());
  }
  return mesh;
}

double signedVolume(const MeshShape& mesh) {
  double volume = 0.0;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    volume += signedVolume(cornersOf(mesh, triangle));
  }
  return volume;
}

bool servesAsHull(const MeshShape& mesh) {
  constexpr std::size_t kMaxTriangles = 2000;
  return mesh.triangles.size() <= kMaxTriangles && isConvex(mesh);
}

bool isConvex(const MeshShape& mesh) {
  // Below the hull, the depth is a concave function that is nowhere negative: on a triangle it is
  // three times that of the centroid at most.
  const double enough = kConvexTolerance * extentOf(mesh).norm() / 3.0;
  const HullDepth depth(mesh, enough);
  constexpr std::size_t kStride = 101;  // a first look everywhere finds most hollows
  for (std::size_t first = 0; first < kStride; ++first) {
    for (std::size_t i = first; i < mesh.triangles.size(); i += kStride) {
      if (!depth.isShallow(mesh.triangles[i])) return false;
    }
  }
  return true;
}

}  // namespace smore
