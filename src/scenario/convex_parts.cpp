// SPDX-License-Identifier: BSD-3-Clause
#include "convex_parts.h"

#include <HACD/hacdHACD.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "smore/common/result.h"
#include "smore/scenario/mesh.h"
#include "smore/scenario/solid_distance.h"
#include "triangle_tree.h"

namespace smore {
namespace {

// HACD's time grows faster than the number of triangles; so many take it seconds, and a minute
// where faces are long and narrow.
constexpr std::size_t kMaxTriangles = 2000;
// Concavity of a part, in thousandths of the mesh's size; HACD scales the mesh to 1000.
constexpr double kConcavity = 10.0;
// Weight of the parts' compactness against their concavity, as HACD's own programs have it.
constexpr double kCompactness = 0.1;
constexpr std::size_t kMaxVertices = 200;  // of a part's hull
// Parts that are nearer to the mesh than this, in its size, are good enough. Ours.
constexpr double kGoodError = 0.01;
// The error is measured at points of the surfaces so far apart, in the mesh's size.
constexpr double kErrorSpacing = 0.01;

double sizeOf(const MeshShape& mesh) {
  const Bounds bounds = boundsOf({{mesh, Pose::Identity()}});
  return (bounds.max - bounds.min).norm();
}

// All vertices of a cell of the size `cell` become the first one of them.
MeshShape joinedWithinCells(const MeshShape& mesh, double cell) {
  MeshShape coarse;
  std::map<std::array<long, 3>, int> indices;
  std::vector<int> index_of(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 at = mesh.vertices[i] / cell;
    const std::array<long, 3> key = {std::lround(at.x()), std::lround(at.y()), std::lround(at.z())};
    const auto entry = indices.emplace(key, static_cast<int>(coarse.vertices.size()));
    if (entry.second) coarse.vertices.push_back(mesh.vertices[i]);
    index_of[i] = entry.first->second;
  }
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Eigen::Vector3i joined;
    for (int i = 0; i < 3; ++i) joined[i] = index_of[static_cast<std::size_t>(triangle[i])];
    if (joined[0] != joined[1] && joined[1] != joined[2] && joined[2] != joined[0]) {
      coarse.triangles.push_back(joined);
    }
  }
  return coarse;
}

MeshShape coarsened(const MeshShape& mesh) {
  constexpr double kFirstCell = 1.0 / 256.0;  // of the mesh's size
  constexpr double kCellGrowth = 1.25;
  MeshShape coarse = mesh;
  for (double cell = kFirstCell * sizeOf(mesh); coarse.triangles.size() > kMaxTriangles;
       cell *= kCellGrowth) {
    coarse = joinedWithinCells(mesh, cell);
  }
  return coarse;
}

// Each triangle becomes four, by the middles of its sides.
MeshShape withSplitTriangles(const MeshShape& mesh) {
  MeshShape split;
  split.vertices = mesh.vertices;
  std::map<std::pair<int, int>, int> middles;
  const auto halfway = [&](int a, int b) {
    const auto entry = middles.emplace(std::minmax(a, b), static_cast<int>(split.vertices.size()));
    if (entry.second) split.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    return entry.first->second;
  };
  for (const Eigen::Vector3i& corners : mesh.triangles) {
    const Eigen::Vector3i middle(halfway(corners[0], corners[1]), halfway(corners[1], corners[2]),
                                 halfway(corners[2], corners[0]));
    split.triangles.push_back(middle);
    split.triangles.emplace_back(corners[0], middle[0], middle[2]);
    split.triangles.emplace_back(corners[1], middle[1], middle[0]);
    split.triangles.emplace_back(corners[2], middle[2], middle[1]);
  }
  return split;
}

ConvexPart partOf(HACD::HACD* hacd, std::size_t cluster) {
  std::vector<HACD::Vec3<HACD::Real>> points(hacd->GetNPointsCH(cluster));
  std::vector<HACD::Vec3<long>> triangles(hacd->GetNTrianglesCH(cluster));
  hacd->GetCH(cluster, points.data(), triangles.data());
  ConvexPart part;
  for (const auto& point : points) part.vertices.emplace_back(point.X(), point.Y(), point.Z());
  for (const auto& triangle : triangles) {
    part.triangles.emplace_back(static_cast<int>(triangle.X()), static_cast<int>(triangle.Y()),
                                static_cast<int>(triangle.Z()));
  }
  return part;
}

std::vector<ConvexPart> partsOf(const MeshShape& mesh) {
  std::vector<HACD::Vec3<HACD::Real>> points;
  for (const Vec3& vertex : mesh.vertices) {
    points.emplace_back(vertex.x(), vertex.y(), vertex.z());
  }
  std::vector<HACD::Vec3<long>> triangles;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    triangles.emplace_back(triangle.x(), triangle.y(), triangle.z());
  }
  HACD::HACD hacd;
  hacd.SetPoints(points.data());
  hacd.SetNPoints(points.size());
  hacd.SetTriangles(triangles.data());
  hacd.SetNTriangles(triangles.size());
  hacd.SetNClusters(1);
  hacd.SetConcavity(kConcavity);
  hacd.SetCompacityWeight(kCompactness);
  hacd.SetVolumeWeight(0.0);
  hacd.SetNVerticesPerCH(kMaxVertices);
  // Without points within faces and of neighbours, a few large faces seem convex together.
  hacd.SetAddExtraDistPoints(true);
  hacd.SetAddNeighboursDistPoints(true);
  hacd.SetAddFacesPoints(true);
  hacd.Compute();
  std::vector<ConvexPart> parts;
  for (std::size_t i = 0; i < hacd.GetNClusters(); ++i) parts.push_back(partOf(&hacd, i));
  return parts;
}

// Points of a surface that are at most `spacing` apart along its edges, corners among them.
template <typename Surface, typename Visit>
void visitSurface(const Surface& surface, double spacing, const Visit& visit) {
  for (const Eigen::Vector3i& triangle : surface.triangles) {
    const Vec3& a = surface.vertices[static_cast<std::size_t>(triangle[0])];
    const Vec3 u = surface.vertices[static_cast<std::size_t>(triangle[1])] - a;
    const Vec3 v = surface.vertices[static_cast<std::size_t>(triangle[2])] - a;
    const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
    const int steps = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) visit(a + (i * u + j * v) / steps);
    }
  }
}

// How far the union of the parts stands out of the mesh, or the mesh out of the union.
double errorOf(const MeshShape& mesh) {
  const double spacing = kErrorSpacing * sizeOf(mesh);
  double error = 0.0;
  const SolidDistance to_mesh({{mesh, Pose::Identity()}});
  std::vector<Shape> parts;
  for (const ConvexPart& part : mesh.parts) {
    visitSurface(part, spacing,
                 [&](const Vec3& point) { error = std::max(error, to_mesh(point)); });
    MeshShape solid;
    solid.vertices = part.vertices;
    solid.triangles = part.triangles;
    parts.push_back({solid, Pose::Identity()});
  }
  const SolidDistance to_parts(parts);
  for (const Vec3& vertex : coarsened(mesh).vertices) error = std::max(error, to_parts(vertex));
  return error;
}

}  // namespace

// HACD joins faces, so that few large ones leave it no place to cut at: where the parts are far off
// the mesh, its triangles are made smaller, and the best parts are taken.
void decompose(MeshShape* mesh) {
  MeshShape cut = coarsened(*mesh);
  if (cut.triangles.empty()) {
    throw InputError(mesh->file + ": is too thin for its " +
                     std::to_string(mesh->triangles.size()) +
                     " triangles, of which none is left where they are made fewer; give it with " +
                     std::to_string(kMaxTriangles) + " at most");
  }
  if (isConvex(*mesh)) {  // and HACD, to which it is no less work, would be slow to find that out
    mesh->parts = {{cut.vertices, cut.triangles}};
    mesh->parts_error = errorOf(*mesh);
    return;
  }
  mesh->parts = partsOf(cut);
  mesh->parts_error = errorOf(*mesh);
  const double good = kGoodError * sizeOf(*mesh);
  while (mesh->parts_error > good && 4 * cut.triangles.size() <= kMaxTriangles) {
    cut = withSplitTriangles(cut);
    MeshShape finer = *mesh;
    finer.parts = partsOf(cut);
    finer.parts_error = errorOf(finer);
    if (finer.parts_error < mesh->parts_error) *mesh = std::move(finer);
  }
}

}  // namespace smore
