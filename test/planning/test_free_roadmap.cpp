// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/mapping/free_tracks.h"
#include "smore/planning/free_roadmap.h"

namespace smore {
namespace {

constexpr FreeSpaceParameters kCells = {0.008, 0.02};  // [m], [rad]

constexpr double kUnit = 0.1;  // of length [m]

Pose at(double x, double y) { return makePose(Vec3(x, y, 0.0)); }

double lengthTo(const FreeRoadmap& roadmap, const Pose& pose) {
  for (std::size_t i = 0; i < roadmap.reachable().size(); ++i) {
    if (roadmap.reachable()[i].isApprox(pose)) {
      const Path route = roadmap.routeTo(static_cast<int>(i));
      EXPECT_TRUE(route.back().isApprox(pose));
      return pathLength(route);
    }
  }
  return -1.0;
}

TEST(FreeRoadmap, goesAlongTheTracksAndChangesWhereTheyCross) {
  const std::vector<Path> tracks = {{at(0, 0), at(0.1, 0), at(0.2, 0)},
                                    {at(0.1, 0.005), at(0.1, 0.1)}};
  const FreeRoadmap roadmap(tracks, at(0, 0), kCells, kUnit);
  EXPECT_NEAR(lengthTo(roadmap, at(0.2, 0)), 0.2, 1e-12);
  EXPECT_NEAR(lengthTo(roadmap, at(0.1, 0.1)), std::hypot(0.1, 0.005) + 0.095, 1e-12);
}

TEST(FreeRoadmap, takesTheShorterOfTwoWays) {
  const std::vector<Path> tracks = {{at(0, 0), at(0, 0.3), at(0.4, 0.3), at(0.4, 0)},
                                    {at(0, 0), at(0.2, 0.1), at(0.4, 0)}};
  const FreeRoadmap roadmap(tracks, at(0, 0), kCells, kUnit);
  EXPECT_NEAR(lengthTo(roadmap, at(0.4, 0)), 2.0 * std::hypot(0.2, 0.1), 1e-12);
}

TEST(FreeRoadmap, leavesOutWhatNoFreeMotionLeadsTo) {
  const std::vector<Path> tracks = {{at(0, 0), at(0.1, 0)}, {at(0.1, 0.02), at(0.1, 0.1)}};
  const FreeRoadmap roadmap(tracks, at(0, 0), kCells, kUnit);
  EXPECT_EQ(lengthTo(roadmap, at(0.1, 0.1)), -1.0);
}

// Tracks are thinned: the object is rarely at one of their poses, and two rarely cross there.
TEST(FreeRoadmap, joinsWhatLiesBetweenTwoPosesOfATrack) {
  const std::vector<Path> tracks = {{at(0, 0), at(0.045, 0), at(0.09, 0)},
                                    {at(0.065, -0.03), at(0.065, 0.004)}};
  const FreeRoadmap roadmap(tracks, at(0.02, 0.003), kCells, kUnit);
  EXPECT_NEAR(lengthTo(roadmap, at(0.09, 0)), 0.07, 1e-3);
  EXPECT_NEAR(lengthTo(roadmap, at(0, 0)), 0.02, 1e-3);
  EXPECT_GT(lengthTo(roadmap, at(0.065, -0.03)), 0.07);
  const FreeRoadmap beside(tracks, at(0.02, 0.06), kCells, kUnit);
  EXPECT_EQ(lengthTo(beside, at(0, 0)), -1.0);
}

TEST(FreeRoadmap, joinsTurnsOnTheSpot) {
  const auto turned = [](double angle) { return makePose(Vec3::Zero(), {0, 0, angle}); };
  const FreeRoadmap roadmap({{turned(0.0), turned(0.14), turned(0.28)}}, turned(0.2), kCells,
                            kUnit);
  EXPECT_NEAR(lengthTo(roadmap, turned(0.0)), 0.0, 1e-9) << "metres";
}

// All that follows is what a robot has done: it goes back, or on from where its last motion ended.
TEST(FreeRoadmap, goesBackFromAnywhereOnTheWayThatWasDriven) {
  Path trail;
  for (const Pose& pose :
       densify({at(0, 0), at(0.3, 0.1), makePose(Vec3(0.3, 0.4, 0), {0, 0, 0.5})}, 0.0021, 0.005)) {
    trail.push_back(pose);
  }
  for (std::size_t end = 1; end < trail.size(); ++end) {
    const Path driven(trail.begin(), trail.begin() + static_cast<std::ptrdiff_t>(end));
    const FreeRoadmap roadmap(freeTracks(driven, kUnit), driven.back(), kCells, kUnit);
    EXPECT_GE(lengthTo(roadmap, at(0, 0)), 0.0) << "after a motion of " << end << " poses";
    const FreeRoadmap after(freeTracks(trail, kUnit), driven.back(), kCells, kUnit);
    EXPECT_GE(lengthTo(after, at(0, 0)), 0.0) << "back at pose " << end;
  }
}

TEST(FreeRoadmap, tracksAreCutWhereTheyLeaveTheWorkspace) {
  MotionSpace space;
  space.workspace = {Vec3(-0.1, -0.1, -0.1), Vec3(0.1, 0.1, 0.1)};
  const std::vector<Path> within = tracksWithin(
      space, {{at(0, 0), at(0.105, 0), at(0.12, 0), at(0.1, 0.05), at(0, 0.05)}, {at(0.3, 0)}});
  ASSERT_EQ(within.size(), 2U);
  EXPECT_EQ(within[0].size(), 2U) << "an arm is never quite where it was sent";
  EXPECT_EQ(within[1].size(), 2U);
}

TEST(FreeRoadmap, beginsWhereTheObjectIsWhateverIsKnown) {
  const FreeRoadmap roadmap({}, at(0.3, 0.2), kCells, kUnit);
  ASSERT_EQ(roadmap.reachable().size(), 1u);
  EXPECT_EQ(roadmap.routeTo(0).size(), 1u);
}

}  // namespace
}  // namespace smore
