// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "smore/simulation/mass_properties.h"

namespace smore {
namespace {

Eigen::Matrix3d diagonal(double x, double y, double z) { return Vec3(x, y, z).asDiagonal(); }

// A box about its own centre as a closed mesh of twelve triangles.
MeshShape boxMesh(const Vec3& size) {
  MeshShape mesh;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5);
    mesh.vertices.push_back(corner.cwiseProduct(size));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(MassProperties, boxInClosedForm) {
  const MassProperties body =
      massProperties({{BoxShape{Vec3(1, 2, 3)}, makePose(Vec3(4, 5, 6))}}, 12.0);
  EXPECT_DOUBLE_EQ(body.mass, 12.0);
  EXPECT_TRUE(body.center.isApprox(Vec3(4, 5, 6), 1e-12));
  EXPECT_TRUE(body.inertia.isApprox(diagonal(13, 10, 5), 1e-12));
}

TEST(MassProperties, cylinderAndSphereInClosedForm) {
  const MassProperties rod = massProperties({{CylinderShape{1.0, 6.0}, Pose::Identity()}}, 12.0);
  EXPECT_TRUE(rod.inertia.isApprox(diagonal(39, 39, 6), 1e-12));
  const MassProperties ball = massProperties({{SphereShape{2.0}, Pose::Identity()}}, 5.0);
  EXPECT_TRUE(ball.inertia.isApprox(diagonal(8, 8, 8), 1e-12));
}

TEST(MassProperties, meshOfABoxIsTheBox) {
  const Pose pose = makePose(Vec3(0.1, -0.2, 0.3), Vec3(0.4, 0.5, 0.6));
  const MassProperties mesh = massProperties({{boxMesh(Vec3(0.3, 0.2, 0.1)), pose}}, 2.0);
  const MassProperties box = massProperties({{BoxShape{Vec3(0.3, 0.2, 0.1)}, pose}}, 2.0);
  EXPECT_TRUE(mesh.center.isApprox(box.center, 1e-12));
  EXPECT_TRUE(mesh.inertia.isApprox(box.inertia, 1e-12));
}

// Two halves of a box in the same material are the whole box.
TEST(MassProperties, partsAddUp) {
  const Pose turn = makePose(Vec3(1, 2, 3), Vec3(0.3, -0.2, 0.9));
  const Shape left{BoxShape{Vec3(1, 2, 2)}, turn * makePose(Vec3(-0.5, 0, 0))};
  const Shape right{BoxShape{Vec3(1, 2, 2)}, turn * makePose(Vec3(0.5, 0, 0))};
  const MassProperties parts = massProperties({left, right}, 3.0);
  const MassProperties whole = massProperties({{BoxShape{Vec3(2, 2, 2)}, turn}}, 3.0);
  EXPECT_TRUE(parts.center.isApprox(whole.center, 1e-12));
  EXPECT_TRUE(parts.inertia.isApprox(whole.inertia, 1e-12));
}

// Kinetic energy by the spatial inertia against the sum over points strewn in the solids.
TEST(MassProperties, spatialInertiaGivesTheKineticEnergyOfThePoints) {
  const Vec3 size(0.4, 0.1, 0.2);
  const Pose pose = makePose(Vec3(0.2, 0.1, -0.3), Vec3(0.5, 0.1, -0.7));
  const auto inertia = spatialInertia(massProperties({{BoxShape{size}, pose}}, 0.5));
  Eigen::Matrix<double, 6, 1> twist;
  twist << 0.3, -0.2, 0.5, 1.0, 2.0, -1.5;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  constexpr int kPoints = 200000;
  double energy = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const Vec3 cube(uniform(random), uniform(random), uniform(random));
    const Vec3 point = pose * cube.cwiseProduct(size);
    energy += 0.5 * 0.5 / kPoints * (twist.head<3>() + twist.tail<3>().cross(point)).squaredNorm();
  }
  EXPECT_NEAR(0.5 * twist.dot(inertia * twist), energy, 0.005 * energy);
}

}  // namespace
}  // namespace smore
