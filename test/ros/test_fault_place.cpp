// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/ros/fault_place.h"

namespace smore {
namespace {

Pose at(double x) { return makePose(Vec3(x, 0, 0), Vec3::Zero()); }

TEST(FaultPlace, isHereUntilTheObjectHasMovedFromWhereTheFaultBegan) {
  FaultPlace place;
  place.observe(at(0.0), false);
  EXPECT_FALSE(place.isHere());
  place.observe(at(0.1), true);
  place.observe(at(0.103), true);
  place.observe(at(0.103), false);
  EXPECT_TRUE(place.isHere()) << "a bent arm has not been moved";
  place.observe(at(0.08), false);
  EXPECT_FALSE(place.isHere());
  place.observe(at(0.1), false);
  EXPECT_FALSE(place.isHere()) << "only a new fault makes it one again";
}

TEST(FaultPlace, isLeftByAMotionDuringTheFault) {
  FaultPlace place;
  place.observe(at(0.0), true);
  place.observe(at(0.05), true);
  place.observe(at(0.05), false);
  EXPECT_FALSE(place.isHere());
}

}  // namespace
}  // namespace smore
