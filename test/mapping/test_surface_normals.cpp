// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "smore/mapping/surface_normals.h"

namespace smore {
namespace {

using Vec3f = Eigen::Vector3f;

const SurfaceSpread kSpread{0.2F, 0.02F, 1.0F};

class Draws {
 public:
  explicit Draws(unsigned seed) : engine_(seed) {}
  float uniform(float least, float most) {
    return std::uniform_real_distribution<float>(least, most)(engine_);
  }
  /// As forces are that friction tilts by up to 0.29 rad, mostly by all of that.
  Vec3f tilted(const Vec3f& normal) {
    const Vec3f first = normal.unitOrthogonal();
    const float turn = uniform(0.0F, 6.28F);
    const Vec3f along = std::cos(turn) * first + std::sin(turn) * normal.cross(first);
    const float angle = 0.29F * std::sqrt(uniform(0.5F, 1.0F));
    return std::cos(angle) * normal + std::sin(angle) * along;
  }
  /// On the square of half a metre around the centre, 1 cm about the plane.
  TouchedPoint on(const Vec3f& center, const Vec3f& normal) {
    const Vec3f first = normal.unitOrthogonal();
    const Vec3f second = normal.cross(first);
    const Vec3f point = center + uniform(-0.25F, 0.25F) * first + uniform(-0.25F, 0.25F) * second +
                        uniform(-0.01F, 0.01F) * normal;
    return {point, tilted(normal)};
  }

 private:
  std::mt19937 engine_;
};

float angleBetween(const Vec3f& a, const Vec3f& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(SurfaceNormals, AreTheForcesWhereNothingElseWasTouched) {
  EXPECT_TRUE(surfaceNormals({}, kSpread).empty());
  const Vec3f force = Vec3f(0.1F, -0.2F, 1.0F).normalized();
  const TouchedPoint touch{{0.3F, 0.1F, 0.0F}, force};
  const TouchedPoint too_far{{0.3F, 0.1F, 1.1F}, force};
  const auto normals = surfaceNormals({touch, too_far}, kSpread);
  ASSERT_EQ(normals.size(), 2U);
  EXPECT_LT((normals[0] - force).norm(), 1e-6F);
  EXPECT_LT((normals[1] - force).norm(), 1e-6F);
}

// Two touches: the plane through both, but for what the forces say, which weighs as a tilt of 0.2
// rad beside 2 cm over their distance.
TEST(SurfaceNormals, AreTheLikeliestForTwoTouches) {
  for (const float slope : {0.02F, 0.05F, 0.1F}) {
    const float distance = 0.2F;
    const std::vector<TouchedPoint> touches = {
        {Vec3f::Zero(), Vec3f::UnitZ()}, {{distance, 0.0F, distance * slope}, Vec3f::UnitZ()}};
    // The fixed point of the reweighting, found by itself.
    float expected = 0.0F;
    for (int i = 0; i < 100; ++i) {
      const float off = distance * (slope - expected) / 0.02F;
      const float weight = std::pow(1.0F / (1.0F + off * off) * distance / 0.02F, 2.0F);
      expected = slope * weight / (weight + 1.0F / (0.2F * 0.2F));
    }
    const Vec3f normal = surfaceNormals(touches, kSpread).front();
    EXPECT_NEAR(normal.x() / normal.z(), -expected, 0.05F * slope) << slope;
    EXPECT_NEAR(normal.y(), 0.0F, 1e-6F);
  }
}

TEST(SurfaceNormals, OfOnePlaneAreFarNearerToItThanTheForces) {
  float of_all_forces = 0.0F;
  float of_all_normals = 0.0F;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Draws draws(seed);
    const Vec3f plane =
        Vec3f(draws.uniform(-1.0F, 1.0F), draws.uniform(-1.0F, 1.0F), 1.0F).normalized();
    std::vector<TouchedPoint> touches;
    for (int i = 0; i < 12; ++i) touches.push_back(draws.on({1.0F, 2.0F, 3.0F}, plane));
    const std::vector<Vec3f> normals = surfaceNormals(touches, kSpread);
    float of_forces = 0.0F;
    float of_normals = 0.0F;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      of_forces += angleBetween(touches[k].normal, plane);
      of_normals += angleBetween(normals[k], plane);
    }
    EXPECT_LT(of_normals, 0.6F * of_forces) << seed;
    of_all_forces += of_forces;
    of_all_normals += of_normals;
  }
  EXPECT_LT(of_all_normals, 0.3F * of_all_forces);
}

// The faces of a corner, and the two sides of a plate.
TEST(SurfaceNormals, OfSeveralSurfacesAreNotMixed) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Draws draws(seed);
    std::vector<TouchedPoint> touches;
    std::vector<Vec3f> planes;
    for (int i = 0; i < 8; ++i) {
      for (const Vec3f& plane :
           {Vec3f(Vec3f::UnitX()), Vec3f(Vec3f::UnitY()), Vec3f(-Vec3f::UnitX())}) {
        const Vec3f inside(0.2F, 0.1F, 0.0F);
        touches.push_back(draws.on(inside + 0.1F * plane, plane));
        planes.push_back(plane);
      }
    }
    const std::vector<Vec3f> normals = surfaceNormals(touches, kSpread);
    float of_forces = 0.0F;
    float of_normals = 0.0F;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      of_forces += angleBetween(touches[k].normal, planes[k]);
      of_normals += angleBetween(normals[k], planes[k]);
    }
    EXPECT_LT(of_normals, 0.8F * of_forces) << seed;
  }
}

TEST(SurfaceNormals, StayInTheConeOfFrictionWhateverElseWasTouched) {
  Draws draws(7);
  for (int i = 0; i < 200; ++i) {
    std::vector<TouchedPoint> touches;
    for (int k = 0; k < 10; ++k) {
      const Vec3f any(draws.uniform(-0.2F, 0.2F), draws.uniform(-0.2F, 0.2F),
                      draws.uniform(-0.2F, 0.2F));
      touches.push_back({any, draws.tilted(Vec3f::UnitZ())});
    }
    touches.push_back(touches.front());  // the same place twice
    const std::vector<Vec3f> normals = surfaceNormals(touches, kSpread);
    for (std::size_t k = 0; k < touches.size(); ++k) {
      EXPECT_NEAR(normals[k].norm(), 1.0F, 1e-5F);
      EXPECT_LE(angleBetween(normals[k], touches[k].normal), 0.3F + 1e-4F);
    }
  }
}

}  // namespace
}  // namespace smore
