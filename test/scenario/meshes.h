// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

#include "smore/scenario/shape.h"

namespace smore {

/// Wavefront OBJ text of a prism: `outline` counter-clockwise in x and y, z from 0 to `height`. The
/// caps are fans about the first corner, which must see all others, or `whole` polygons.
inline std::string prismObj(const std::vector<Eigen::Vector2d>& outline, double height,
                            bool whole = false) {
  std::ostringstream text;
  text.precision(17);
  const size_t n = outline.size();
  for (const double z : {0.0, height}) {
    for (const Eigen::Vector2d& p : outline)
      text << "v " << p.x() << " " << p.y() << " " << z << "\n";
  }
  if (whole) {
    text << "f";
    for (size_t i = n; i > 0; --i) text << " " << i;
    text << "\nf";
    for (size_t i = 1; i <= n; ++i) text << " " << n + i;
    text << "\n";
  }
  for (size_t i = 2; i < n && !whole; ++i) {
    text << "f 1 " << i + 1 << " " << i << "\n";
    text << "f " << n + 1 << " " << n + i << " " << n + i + 1 << "\n";
  }
  for (size_t i = 0; i < n; ++i) {
    const size_t j = (i + 1) % n;
    text << "f " << i + 1 << " " << j + 1 << " " << n + j + 1 << " " << n + i + 1 << "\n";
  }
  return text.str();
}

/// A cube from 0 to 1 on each axis.
inline std::string cubeObj() { return prismObj({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1.0); }

/// An L of three unit squares, with the inner corner at (1, 1), first in the list: it sees all
/// others.
inline std::string ellObj() {
  return prismObj({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}, 1.0);
}

inline const Vec3& vertexAt(const MeshShape& mesh, int index) {
  return mesh.vertices[static_cast<size_t>(index)];
}

/// Text of an STL file; `digits` of each coordinate.
inline std::string asciiStl(const MeshShape& mesh, int digits = 17) {
  std::ostringstream text;
  text.precision(digits);
  text << "solid test\n";
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    text << "facet normal 0 0 0\n outer loop\n";
    for (int corner = 0; corner < 3; ++corner) {
      text << "  vertex " << vertexAt(mesh, triangle[corner]).transpose() << "\n";
    }
    text << " endloop\nendfacet\n";
  }
  return text.str() + "endsolid test\n";
}

}  // namespace smore
