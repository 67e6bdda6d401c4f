// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "smore/scenario/solid_distance.h"
#include "smore/scenario/tessellation.h"

namespace smore {
namespace {

using Random = std::mt19937;

Vec3 draw(Random* random, double half_width) {
  std::uniform_real_distribution<double> uniform(-half_width, half_width);
  return {uniform(*random), uniform(*random), uniform(*random)};
}

// The distance to the nearest of a triangle's points on a fine lattice: never too small.
double latticeDistance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point, int steps) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const Vec3 at = a + (i * (b - a) + j * (c - a)) / steps;
      least = std::min(least, (at - point).norm());
    }
  }
  return least;
}

// Solid angle of a triangle seen from a point (Van Oosterom and Strackee, 1983).
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double denominator = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                             b.dot(c) * a.norm() + c.dot(a) * b.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)), denominator);
}

// A star-shaped solid with sharp spikes, hollows and slivers.
MeshShape spikes(Random* random) {
  MeshShape mesh = tessellate({SphereShape{1.0}, Pose::Identity()});
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (Vec3& vertex : mesh.vertices) vertex *= std::pow(10.0, -uniform(*random));
  return mesh;
}

TEST(SolidDistance, ofAMeshAgreesWithItsTrianglesOneByOne) {
  Random random(1);
  for (int trial = 0; trial < 3; ++trial) {
    const MeshShape mesh = spikes(&random);
    const SolidDistance distance_to({{mesh, Pose::Identity()}});
    for (int i = 0; i < 20; ++i) {
      const Vec3 point = draw(&random, i % 2 == 0 ? 0.3 : 1.2);
      constexpr int kSteps = 12;
      double nearest = std::numeric_limits<double>::infinity();
      double longest = 0.0;
      double angle = 0.0;
      for (const Eigen::Vector3i& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3& b = mesh.vertices[t[1]];
        const Vec3& c = mesh.vertices[t[2]];
        nearest = std::min(nearest, latticeDistance(a, b, c, point, kSteps));
        longest = std::max({longest, (a - b).norm(), (b - c).norm(), (c - a).norm()});
        angle += solidAngle(a - point, b - point, c - point);
      }
      const double distance = distance_to(point);
      EXPECT_LE(std::abs(distance), nearest + 1e-12);
      EXPECT_GE(std::abs(distance), nearest - longest / kSteps);
      EXPECT_EQ(distance<0.0, angle> 2.0 * M_PI) << "seen under 4 pi from inside, 0 from outside";
    }
  }
}

// Rays and boxes at points that lie on the planes, edges and corners of others.
TEST(SolidDistance, ofAMeshOnAGridIsThatOfTheBox) {
  const Shape box{BoxShape{Vec3(1, 2, 3)}, makePose(Vec3(0.5, 0, 0))};
  const SolidDistance mesh({{tessellate(box), Pose::Identity()}});
  const SolidDistance exact({box});
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      for (int z = -6; z <= 6; ++z) {
        const Vec3 point = 0.5 * Vec3(x, y, z);
        EXPECT_NEAR(mesh(point), exact(point), 1e-12) << point.transpose();
      }
    }
  }
}

TEST(SolidDistance, ofTwoShellsInOneMeshIsThatOfTheirUnion) {
  const std::vector<Shape> spheres{{SphereShape{1.0}, makePose(Vec3(-0.5, 0, 0))},
                                   {SphereShape{1.0}, makePose(Vec3(0.5, 0, 0))}};
  MeshShape both = tessellate(spheres[0]);
  const MeshShape second = tessellate(spheres[1]);
  const auto first = static_cast<int>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const Eigen::Vector3i& t : second.triangles) {
    both.triangles.push_back(t + Eigen::Vector3i::Constant(first));
  }
  const SolidDistance mesh({{both, Pose::Identity()}});
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 point = draw(&random, 1.6);
    const double expected = signedDistance(spheres, point);
    if (std::abs(expected) < 0.01) continue;  // a sphere's facets
    EXPECT_EQ(mesh(point) < 0.0, expected < 0.0) << point.transpose();
  }
}

}  // namespace
}  // namespace smore
