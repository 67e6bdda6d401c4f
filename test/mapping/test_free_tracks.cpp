// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/mapping/free_tracks.h"

namespace smore {
namespace {

// Along x, in steps that are fine against the unit.
Path motion(double from, double to, double unit) {
  return densify({makePose({from * unit, 0, 0}), makePose({to * unit, 0, 0})}, 0.05 * unit, 1.0);
}

TEST(FreeTracks, AreCutWhereTheObjectWasSetElsewhereAtAnySize) {
  for (const double unit : {0.002, 0.1, 4.0}) {
    Path trail = motion(0.0, 10.0, unit);
    const Path second = motion(2.0, 6.0, unit);
    trail.insert(trail.end(), second.begin(), second.end());
    const std::vector<Path> tracks = freeTracks(trail, unit);
    ASSERT_EQ(tracks.size(), 2U);
    EXPECT_TRUE(tracks[0].front().isApprox(trail.front()));
    EXPECT_TRUE(tracks[1].front().isApprox(second.front()));
    EXPECT_NEAR(static_cast<double>(tracks[0].size()), 20.0, 2.0) << "thinned";
  }
  EXPECT_TRUE(freeTracks({}, 0.1).empty());
}

}  // namespace
}  // namespace smore
