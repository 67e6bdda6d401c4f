// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/tessellation.h"

#include <cmath>

namespace smore {
namespace {

constexpr int kCorners = 96;  // of a circle
constexpr int kBands = 48;    // of a sphere, from pole to pole

/// Builds a surface from rings of equally many vertices, each counter-clockwise from above and
/// above the one before, between one vertex at the bottom and one at the top.
class RingSurface {
 public:
  explicit RingSurface(const Vec3& bottom) { mesh_.vertices.push_back(bottom); }

  void addRing(const std::vector<Vec3>& ring) {
    const int count = static_cast<int>(ring.size());
    const int first = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.insert(mesh_.vertices.end(), ring.begin(), ring.end());
    for (int i = 0; i < count; ++i) {
      const int here = first + i;
      const int next = first + (i + 1) % count;
      if (first == 1) {
        mesh_.triangles.emplace_back(0, next, here);
      } else {
        mesh_.triangles.emplace_back(here - count, next - count, next);
        mesh_.triangles.emplace_back(here - count, next, here);
      }
    }
    last_ring_ = first;
  }

  MeshShape closeAt(const Vec3& top) {
    const int apex = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.push_back(top);
    for (int i = last_ring_; i < apex; ++i) {
      mesh_.triangles.emplace_back(i, i + 1 < apex ? i + 1 : last_ring_, apex);
    }
    return std::move(mesh_);
  }

 private:
  MeshShape mesh_;
  int last_ring_ = 0;
};

std::vector<Vec3> circle(double radius, double z) {
  std::vector<Vec3> ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return ring;
}

MeshShape surfaceOf(const BoxShape& box) {
  const Vec3 half = box.size / 2.0;
  RingSurface surface(Vec3(0, 0, -half.z()));
  for (const double z : {-half.z(), half.z()}) {
    surface.addRing({Vec3(half.x(), half.y(), z), Vec3(-half.x(), half.y(), z),
                     Vec3(-half.x(), -half.y(), z), Vec3(half.x(), -half.y(), z)});
  }
  return surface.closeAt(Vec3(0, 0, half.z()));
}

MeshShape surfaceOf(const CylinderShape& cylinder) {
  const double half = cylinder.length / 2.0;
  RingSurface surface(Vec3(0, 0, -half));
  for (const double z : {-half, half}) surface.addRing(circle(cylinder.radius, z));
  return surface.closeAt(Vec3(0, 0, half));
}

MeshShape surfaceOf(const SphereShape& sphere) {
  RingSurface surface(Vec3(0, 0, -sphere.radius));
  for (int band = 1; band < kBands; ++band) {
    const double latitude = M_PI * (static_cast<double>(band) / kBands - 0.5);
    surface.addRing(circle(sphere.radius * std::cos(latitude), sphere.radius * std::sin(latitude)));
  }
  return surface.closeAt(Vec3(0, 0, sphere.radius));
}

MeshShape surfaceOf(const MeshShape& mesh) { return mesh; }

}  // namespace

MeshShape tessellate(const Shape& shape) {
  MeshShape mesh = std::visit([](const auto& solid) { return surfaceOf(solid); }, shape.geometry);
  for (Vec3& vertex : mesh.vertices) vertex = shape.pose * vertex;
  return mesh;
}

}  // namespace smore
