// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "smore/scenario/shape.h"

namespace smore {
namespace {

Vec3 randomPoint(std::mt19937* random, double reach) {
  std::uniform_real_distribution<double> uniform(-reach, reach);
  return {uniform(*random), uniform(*random), uniform(*random)};
}

Pose randomPose(std::mt19937* random) {
  return makePose(randomPoint(random, 0.5), randomPoint(random, M_PI));
}

TEST(SignedDistance, boxInClosedForm) {
  const std::vector<Shape> box{{BoxShape{Vec3(2, 4, 6)}, makePose(Vec3(1, 0, 0))}};
  EXPECT_DOUBLE_EQ(signedDistance(box, Vec3(1, 0, 0)), -1.0);
  EXPECT_DOUBLE_EQ(signedDistance(box, Vec3(1, 1.5, 0)), -0.5);
  EXPECT_DOUBLE_EQ(signedDistance(box, Vec3(2, 0, 0)), 0.0);
  EXPECT_DOUBLE_EQ(signedDistance(box, Vec3(5, 0, 0)), 3.0);
  EXPECT_DOUBLE_EQ(signedDistance(box, Vec3(5, 6, 0)), 5.0);
  EXPECT_DOUBLE_EQ(signedDistance(box, Vec3(4, 5, 9)), 7.0);
}

TEST(SignedDistance, cylinderInClosedForm) {
  const Pose along_x = makePose(Vec3::Zero(), Vec3(0, M_PI_2, 0));
  const std::vector<Shape> cylinder{{CylinderShape{1.0, 4.0}, along_x}};
  EXPECT_NEAR(signedDistance(cylinder, Vec3::Zero()), -1.0, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, Vec3(1.9, 0, 0)), -0.1, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, Vec3(0, 0, 3)), 2.0, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, Vec3(5, 0, 5)), 5.0, 1e-12);
}

TEST(SignedDistance, sphereAndUnionInClosedForm) {
  const std::vector<Shape> spheres{{SphereShape{1.0}, makePose(Vec3(-2, 0, 0))},
                                   {SphereShape{0.5}, makePose(Vec3(2, 0, 0))}};
  EXPECT_DOUBLE_EQ(signedDistance(spheres, Vec3::Zero()), 1.0);
  EXPECT_DOUBLE_EQ(signedDistance(spheres, Vec3(2, 0, 0)), -0.5);
  EXPECT_EQ(signedDistance({}, Vec3::Zero()), std::numeric_limits<double>::infinity());
}

// The distance is the greatest radius of a ball about the point that stays on one side of the
// surface, asked of nothing but which points are inside: by marching out in many directions.
template <typename Inside>
double marchedDistance(const Vec3& point, const Inside& inside, std::mt19937* random) {
  constexpr int kDirections = 3000;
  constexpr double kStep = 0.01;
  std::normal_distribution<double> normal;
  const bool start = inside(point);
  double nearest = 1.0;
  for (int i = 0; i < kDirections; ++i) {
    const Vec3 direction = Vec3(normal(*random), normal(*random), normal(*random)).normalized();
    for (double s = 0.0; s < nearest; s += kStep) {
      if (inside(point + s * direction) != start) nearest = s;
    }
  }
  return start ? -nearest : nearest;
}

TEST(SignedDistance, agreesWithBruteForceInRandomPoses) {
  std::mt19937 random(3);
  for (int i = 0; i < 10; ++i) {
    const Pose pose = randomPose(&random);
    const bool box = i % 2 == 0;
    Shape shape;
    shape.pose = pose;
    if (box) shape.geometry = BoxShape{Vec3(0.6, 0.4, 0.2)};
    if (!box) shape.geometry = CylinderShape{0.2, 0.5};
    const auto inside = [&](const Vec3& point) {
      const Vec3 p = (pose.inverse() * point).cwiseAbs();
      return box ? p.x() <= 0.3 && p.y() <= 0.2 && p.z() <= 0.1
                 : std::hypot(p.x(), p.y()) <= 0.2 && p.z() <= 0.25;
    };
    const Vec3 point = pose * randomPoint(&random, 0.4);
    EXPECT_NEAR(signedDistance({shape}, point), marchedDistance(point, inside, &random), 0.03);
  }
}

TEST(BoundsOf, inClosedForm) {
  const Pose turned = makePose(Vec3(1, 2, 3), Vec3(0, 0, M_PI_4));
  const Bounds box = boundsOf({{BoxShape{Vec3(2, 2, 4)}, turned}});
  EXPECT_TRUE(box.max.isApprox(Vec3(1 + M_SQRT2, 2 + M_SQRT2, 5), 1e-12));
  EXPECT_TRUE(box.min.isApprox(Vec3(1 - M_SQRT2, 2 - M_SQRT2, 1), 1e-12));
  const Pose tilted = makePose(Vec3::Zero(), Vec3(0, M_PI_4, 0));
  const Bounds cylinder = boundsOf({{CylinderShape{1.0, 2.0}, tilted}});
  EXPECT_TRUE(cylinder.max.isApprox(Vec3(M_SQRT2, 1.0, M_SQRT2), 1e-12));
  const Bounds sphere = boundsOf({{SphereShape{2.0}, turned}});
  EXPECT_TRUE(sphere.min.isApprox(Vec3(-1, 0, 1), 1e-12));
}

// Bounds are tight: they hold every inside point and on each face there is one nearly.
TEST(BoundsOf, areTightForRandomPoses) {
  std::mt19937 random(4);
  for (int i = 0; i < 10; ++i) {
    const Pose pose = randomPose(&random);
    const Shape shape{CylinderShape{0.2, 0.5}, pose};
    const Bounds bounds = boundsOf({shape});
    Vec3 min = Vec3::Constant(10.0);
    Vec3 max = -min;
    for (int k = 0; k < 20000; ++k) {
      const double angle = 2.0 * M_PI * k / 20000;
      const Vec3 rim(0.2 * std::cos(angle), 0.2 * std::sin(angle), k % 2 == 0 ? 0.25 : -0.25);
      min = min.cwiseMin(pose * rim);
      max = max.cwiseMax(pose * rim);
    }
    EXPECT_LT((bounds.min - min).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT((bounds.max - max).cwiseAbs().maxCoeff(), 1e-6);
  }
}

}  // namespace
}  // namespace smore
