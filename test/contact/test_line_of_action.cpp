// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "distance_to_line.h"
#include "smore/contact/line_of_action.h"

namespace smore {
namespace {

constexpr double kMinForce = 1.0;

Vec3 randomVector(std::mt19937* random) {
  std::normal_distribution<double> normal;
  return {normal(*random), normal(*random), normal(*random)};
}

TEST(LineOfAction, passesThroughTheContactPointWithNoPitch) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 contact = randomVector(&random);
    const Vec3 force = 20.0 * randomVector(&random).normalized();
    const auto line = lineOfAction({force, contact.cross(force)}, kMinForce);
    ASSERT_TRUE(line);
    EXPECT_NEAR(distanceToLine(*line, contact), 0.0, 1e-12);
    EXPECT_NEAR(line->pitch, 0.0, 1e-12);
    EXPECT_NEAR(line->force, 20.0, 1e-12);
    EXPECT_NEAR(line->point.dot(line->direction), 0.0, 1e-12);
    EXPECT_TRUE(line->direction.isApprox(force.normalized(), 1e-12));
  }
}

TEST(LineOfAction, pitchIsTheMomentAboutTheLineOverTheForce) {
  const Vec3 contact(0.1, 0.2, 0.0);
  const Vec3 force(0.0, 0.0, 10.0);
  const auto line = lineOfAction({force, contact.cross(force) + Vec3(0, 0, 0.5)}, kMinForce);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->pitch, 0.05, 1e-12);
  EXPECT_TRUE(line->point.isApprox(contact, 1e-12));
}

TEST(LineOfAction, isNeverGivenForAForceThatIsZeroTinyOrNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Wrench bad[] = {{Vec3::Zero(), Vec3::Zero()},        {Vec3(0, 0, 0.999), Vec3(1, 0, 0)},
                        {Vec3(1e-300, 0, 0), Vec3(1, 0, 0)}, {Vec3(nan, 10, 0), Vec3(1, 0, 0)},
                        {Vec3(10, 0, 0), Vec3(nan, 0, 0)},   {Vec3(infinity, 0, 0), Vec3(1, 0, 0)}};
  for (const Wrench& wrench : bad) {
    const auto line = lineOfAction(wrench, kMinForce);
    EXPECT_FALSE(line);
    EXPECT_FALSE(line.reason().empty());
  }
}

TEST(TransformLine, keepsDistances) {
  std::mt19937 random(2);
  const Pose T_a_b = makePose(Vec3(1, 2, 3), Vec3(0.3, -0.7, 2.0));
  for (int i = 0; i < 100; ++i) {
    LineOfAction line;
    line.point = randomVector(&random);
    line.direction = randomVector(&random).normalized();
    const Vec3 point = randomVector(&random);
    EXPECT_NEAR(distanceToLine(transformLine(T_a_b, line), T_a_b * point),
                distanceToLine(line, point), 1e-12);
  }
}

}  // namespace
}  // namespace smore
