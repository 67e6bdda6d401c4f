// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/planning/free_roadmap.h"

namespace smore {
namespace {

constexpr FreeSpaceParameters kCells = {0.008, 0.02};  // [m], [rad]

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
  const FreeRoadmap roadmap(tracks, at(0, 0), kCells);
  EXPECT_NEAR(lengthTo(roadmap, at(0.2, 0)), 0.2, 1e-12);
  EXPECT_NEAR(lengthTo(roadmap, at(0.1, 0.1)), 0.1 + 0.005 + 0.095, 1e-12);
}

TEST(FreeRoadmap, takesTheShorterOfTwoWays) {
  const std::vector<Path> tracks = {{at(0, 0), at(0, 0.3), at(0.4, 0.3), at(0.4, 0)},
                                    {at(0, 0), at(0.2, 0.1), at(0.4, 0)}};
  const FreeRoadmap roadmap(tracks, at(0, 0), kCells);
  EXPECT_NEAR(lengthTo(roadmap, at(0.4, 0)), 2.0 * std::hypot(0.2, 0.1), 1e-12);
}

TEST(FreeRoadmap, leavesOutWhatNoFreeMotionLeadsTo) {
  const std::vector<Path> tracks = {{at(0, 0), at(0.1, 0)}, {at(0.1, 0.02), at(0.1, 0.1)}};
  const FreeRoadmap roadmap(tracks, at(0, 0), kCells);
  EXPECT_EQ(lengthTo(roadmap, at(0.1, 0.1)), -1.0);
}

TEST(FreeRoadmap, beginsWhereTheObjectIsWhateverIsKnown) {
  const FreeRoadmap roadmap({}, at(0.3, 0.2), kCells);
  ASSERT_EQ(roadmap.reachable().size(), 1u);
  EXPECT_EQ(roadmap.routeTo(0).size(), 1u);
}

}  // namespace
}  // namespace smore
