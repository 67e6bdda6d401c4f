// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "smore/common/geometry.h"

namespace smore {
namespace {

TEST(MakePose, turnsAboutFixedAxesInTheOrderRollPitchYaw) {
  const Pose pose = makePose(Vec3(1, 2, 3), Vec3(M_PI / 2, 0, M_PI / 2));
  // Roll takes y to z, yaw leaves z: the point (0, 1, 0) ends above the origin.
  EXPECT_TRUE((pose * Vec3(0, 1, 0)).isApprox(Vec3(1, 2, 4), 1e-12));
  EXPECT_TRUE((pose * Vec3(1, 0, 0)).isApprox(Vec3(1, 3, 3), 1e-12));
}

TEST(RollPitchYaw, MakeThePoseThatTheyAreOf) {
  for (const double pitch : {-M_PI_2, -0.7, 0.0, 1.2, M_PI_2}) {
    const Pose pose = makePose({0, 0, 0}, {0.4, pitch, -0.9});
    const Vec3 rpy = rollPitchYaw(pose);
    EXPECT_NEAR(rpy.y(), pitch, 1e-6);
    EXPECT_TRUE(makePose({0, 0, 0}, rpy).isApprox(pose, 1e-6)) << pitch;
  }
}

TEST(CrossMatrix, TimesAVectorIsTheCrossProduct) {
  const Vec3 v(0.3, -1.2, 0.5);
  const Vec3 w(-0.7, 0.1, 2.0);
  EXPECT_TRUE((crossMatrix(v) * w).isApprox(v.cross(w), 1e-12));
}

TEST(Interpolate, isHalfWayInPositionAndAngle) {
  const Pose a = makePose(Vec3(0, 0, 0));
  const Pose b = makePose(Vec3(2, 0, 0), Vec3(0, 0, 1.0));
  const Pose half = interpolate(a, b, 0.5);
  EXPECT_NEAR(half.translation().x(), 1.0, 1e-12);
  EXPECT_NEAR(angleBetween(a, half), 0.5, 1e-12);
  EXPECT_NEAR(angleBetween(half, b), 0.5, 1e-12);
}

TEST(Densify, keepsPosesAndBoundsBothDistances) {
  const Path path{makePose(Vec3(0, 0, 0)), makePose(Vec3(0.1, 0, 0), Vec3(0, 0, 0.9)),
                  makePose(Vec3(0.1, 0.33, 0), Vec3(0, 0, 0.9))};
  const Path dense = densify(path, 0.05, 0.2);
  for (size_t i = 1; i < dense.size(); ++i) {
    EXPECT_LE(distanceBetween(dense[i - 1], dense[i]), 0.05 + 1e-12);
    EXPECT_LE(angleBetween(dense[i - 1], dense[i]), 0.2 + 1e-9);
  }
  EXPECT_EQ(dense.size(), 1u + 5u + 7u);
  EXPECT_TRUE(dense[5].isApprox(path[1]));
  EXPECT_NEAR(pathLength(dense), pathLength(path), 1e-12);
}

TEST(Densify, ofNothingIsNothing) { EXPECT_TRUE(densify({}, 0.1, 0.1).empty()); }

TEST(TransformWrench, keepsThePowerOfAMotion) {
  // A wrench does the same work on a twist in whichever frame both are expressed.
  const Pose T_a_b = makePose(Vec3(0.3, -0.2, 0.5), Vec3(0.4, 0.5, 0.6));
  const Wrench wrench_b{Vec3(1, 2, 3), Vec3(-1, 0.5, 2)};
  const Wrench wrench_a = transformWrench(T_a_b, wrench_b);
  const Vec3 omega_a(0.7, -0.3, 0.2);
  const Vec3 velocity_a(0.1, 0.4, -0.6);  // of the body's point at the origin of a
  const Vec3 velocity_of_b = velocity_a + omega_a.cross(T_a_b.translation());
  const double power_a = wrench_a.force.dot(velocity_a) + wrench_a.torque.dot(omega_a);
  const double power_b = wrench_b.force.dot(T_a_b.linear().transpose() * velocity_of_b) +
                         wrench_b.torque.dot(T_a_b.linear().transpose() * omega_a);
  EXPECT_NEAR(power_a, power_b, 1e-12);
}

TEST(Bounds, containTheirFaces) {
  const Bounds bounds{Vec3(0, 0, 0), Vec3(1, 1, 1)};
  EXPECT_TRUE(bounds.contains(Vec3(0, 1, 0.5)));
  EXPECT_FALSE(bounds.contains(Vec3(0, 1.001, 0.5)));
}

TEST(ProjectedToPlane, ChangesNothingInThePlane) {
  for (const double angle : {-3.1, -1.0, 0.0, 0.4, 3.1}) {
    const Pose pose = makePose({0.3, -0.2, 0.0}, {0, 0, angle});
    EXPECT_TRUE(projectedToPlane(pose).isApprox(pose, 1e-12));
  }
}

TEST(ProjectedToPlane, IsThePoseInThePlaneThatIsNearest) {
  const Pose pose = makePose({0.3, -0.2, 0.7}, {0.3, -0.4, 1.0});
  const Pose flat = projectedToPlane(pose);
  EXPECT_EQ(flat.translation(), Vec3(0.3, -0.2, 0.0));
  EXPECT_NEAR((flat.linear().col(2) - Vec3::UnitZ()).norm(), 0.0, 1e-12);
  const double gap = (flat.linear() - pose.linear()).norm();
  for (double angle = -3.0; angle < 3.0; angle += 0.01) {
    EXPECT_LE(gap, (makePose({0, 0, 0}, {0, 0, angle}).linear() - pose.linear()).norm() + 1e-12);
  }
}

}  // namespace
}  // namespace smore
