// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "smore/experiment/touchable_surface.h"

namespace smore {
namespace {

// A disc of 4 cm radius beside a hollow square of walls 4 cm thick.
Scenario discBesideHollowSquare() {
  Scenario scenario;
  scenario.object = {{CylinderShape{0.04, 0.06}, Pose::Identity()}};
  const auto wall = [&](double x, double y, double size_x, double size_y) {
    scenario.environment.push_back({BoxShape{Vec3(size_x, size_y, 0.3)}, makePose(Vec3(x, y, 0))});
  };
  wall(0.3, 0.13, 0.3, 0.04);
  wall(0.3, -0.13, 0.3, 0.04);
  wall(0.17, 0.0, 0.04, 0.3);
  wall(0.43, 0.0, 0.04, 0.3);
  scenario.workspace = {Vec3(-0.1, -0.3, -0.01), Vec3(0.4, 0.3, 0.01)};
  return scenario;
}

TEST(TouchableSurface, isWhatCanBeReachedFromTheStart) {
  const Scenario scenario = discBesideHollowSquare();
  const TouchableSurface surface = touchableSurface(scenario);
  ASSERT_FALSE(surface.world.empty());
  for (const Vec3& point : surface.world) {
    EXPECT_NEAR(signedDistance(scenario.environment, point), 0.0, 1e-3);
    const bool inside = std::abs(point.x() - 0.3) < 0.119 && std::abs(point.y()) < 0.119;
    EXPECT_FALSE(inside) << "the cavity is closed: " << point.transpose();
    EXPECT_LT(point.x(), 0.449) << "the workspace ends before the far side";
  }
  const bool near_side = std::any_of(surface.world.begin(), surface.world.end(),
                                     [](const Vec3& p) { return std::abs(p.x() - 0.15) < 1e-3; });
  EXPECT_TRUE(near_side);
  // The disc can be turned, so that all of its outline can touch: one point a centimetre.
  EXPECT_NEAR(static_cast<double>(surface.object.size()), 2.0 * M_PI * 4.0, 10.0);
}

TEST(TouchableSurface, isLeftOutForMotionInSpace) {
  Scenario scenario = discBesideHollowSquare();
  scenario.motion = Motion::kSpatial;
  EXPECT_TRUE(touchableSurface(scenario).object.empty());
}

TEST(SurfaceRecall, isTheShareOfPointsWithinAVoxelOfAnOccupiedOne) {
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 0.5F);
  grid.set({5, 0, 0}, 0.49F);
  const Vec3 center(0.05, 0.05, 0.05);
  EXPECT_EQ(surfaceRecall(grid, {center + Vec3(0.099, 0, 0), center + Vec3(0.101, 0, 0),
                                 center + Vec3(0.5, 0, 0), center}),
            0.5);
  EXPECT_FALSE(surfaceRecall(grid, {}));
}

}  // namespace
}  // namespace smore
