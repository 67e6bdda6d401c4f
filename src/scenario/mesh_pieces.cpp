// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_pieces.h"

#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "triangle_tree.h"

namespace smore {
namespace {

struct Piece {
  double volume = 0.0;  ///< negative for triangles that are clockwise from outside [m^3]
  double largest_area = -1.0;
  TriangleCorners largest;  ///< its largest triangle
};

std::unordered_map<int, Piece> piecesOf(const MeshShape& mesh) {
  std::vector<int> rank(mesh.vertices.size());
  std::vector<int> parent(mesh.vertices.size());
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) sets.make_set(static_cast<int>(i));
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    sets.union_set(triangle[0], triangle[1]);
    sets.union_set(triangle[0], triangle[2]);
  }
  std::unordered_map<int, Piece> pieces;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Piece& piece = pieces[sets.find_set(triangle[0])];
    const TriangleCorners corners = cornersOf(mesh, triangle);
    piece.volume += signedVolume(corners);
    const double area = areaVector(corners).norm();
    if (area <= piece.largest_area) continue;
    piece.largest_area = area;
    piece.largest = corners;
  }
  return pieces;
}

}  // namespace

std::optional<Vec3> pieceInsideOut(const MeshShape& mesh, double least) {
  std::optional<TriangleTree> tree;
  for (const auto& entry : piecesOf(mesh)) {
    const Piece& piece = entry.second;
    if (piece.volume > -least) continue;
    if (!tree) tree.emplace(mesh);
    // Just beyond a clockwise triangle lies what the piece encloses. The mesh winds around that
    // once less than around what surrounds the piece: not at all within a hollow of a solid.
    const Vec3 normal = areaVector(piece.largest);
    constexpr double kBeside = 1e-4;  // of the triangle's size: less than anything it encloses
    const Vec3 centroid = (piece.largest[0] + piece.largest[1] + piece.largest[2]) / 3.0;
    const Vec3 enclosed = centroid + kBeside * normal / std::sqrt(normal.norm());
    if (tree->windingNumber(enclosed) < 0) return piece.largest[0];
  }
  return std::nullopt;
}

}  // namespace smore
