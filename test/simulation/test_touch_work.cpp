// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "contact_trials.h"
#include "smore/contact/sign_check.h"
#include "smore/contact/touch_work.h"

namespace smore {
namespace {

LineOfAction lineThrough(const Vec3& point, const Vec3& direction) {
  return *lineOfAction({direction, point.cross(direction)}, 0.1);
}

TEST(TouchWork, isAllThatTheForceCouldTakeWhereItOpposesTheMotion) {
  const Pose from = makePose(Vec3(0.3, 0.1, 0), Vec3(0, 0, 0.8));
  const Pose to = from * makePose(Vec3(0.004, 0, 0));
  const Vec3 tip(0.2, 0, 0);
  EXPECT_NEAR(touchWorkShare(lineThrough(tip, -5 * Vec3::UnitX()), from, to), -1.0, 1e-9);
  EXPECT_NEAR(touchWorkShare(lineThrough(tip, 5 * Vec3::UnitX()), from, to), 1.0, 1e-9);
  EXPECT_NEAR(touchWorkShare(lineThrough(tip, 5 * Vec3::UnitY()), from, to), 0.0, 1e-9);
  EXPECT_EQ(touchWorkShare(lineThrough(tip, Vec3::UnitY()), from, from), 0.0);
}

TEST(TouchWork, ofATurnIsThatOfItsMoment) {
  const Pose to = makePose(Vec3::Zero(), Vec3(0, 0, 0.01));
  EXPECT_NEAR(touchWorkShare(lineThrough(Vec3(0.2, 0, 0), -Vec3::UnitY()), Pose::Identity(), to),
              -1.0, 1e-9);
}

// Whatever the shapes and the friction, and also with the sensor's errors about a small force.
TEST(TouchWork, ofRandomTouchesIsNeverClearlyPositive) {
  RandomContacts trials(17);
  int seen = 0, clear = 0;
  double most = -1.0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Scenario scenario = trials.scene();
    const auto robot = makeSimulatedRobot(scenario, seed);
    const Pose target = trials.target(scenario.start);
    const auto observation = touch(robot.get(), target);
    if (!observation) continue;
    const Pose& touched = observation->T_world_object;
    const double way = gapBetween(touched, scenario.start);
    const double share =
        touchWorkShare(*observation->line,
                       interpolate(touched, scenario.start, std::min(1.0, 0.004 / way)), touched);
    most = std::max(most, share);
    clear += share < -0.3 ? 1 : 0;
    ++seen;
  }
  RecordProperty("most", std::to_string(most));
  EXPECT_GT(seen, 100);
  EXPECT_LT(most, 0.1);
  EXPECT_GT(clear, seen * 2 / 3) << "few tell the sign";
}

class SignCheckOfAPush : public testing::Test {
 protected:
  Pose from_ = Pose::Identity();
  Pose to_ = makePose(Vec3(0.004, 0, 0));
  LineOfAction against_ = lineThrough(Vec3(0.1, 0, 0), -Vec3::UnitX());
  LineOfAction along_ = lineThrough(Vec3(0.1, 0, 0), Vec3::UnitX());
  LineOfAction graze_ = lineThrough(Vec3(0.1, 0, 0), Vec3(0.1, 1, 0));
  SignCheck sign_;
};

TEST_F(SignCheckOfAPush, namesTheParameterWhereTheTouchPulls) {
  EXPECT_NE(sign_.contradiction(along_, from_, to_).find("wrench_sign: -1"), std::string::npos);
  EXPECT_NE(sign_.contradiction(along_, from_, to_), "") << "it is not told twice";
}

TEST_F(SignCheckOfAPush, saysNothingOfAGrazeOrOfAnUncertainLine) {
  EXPECT_EQ(sign_.contradiction(graze_, from_, to_), "");
  along_.direction_stddev = 0.3;
  EXPECT_EQ(sign_.contradiction(along_, from_, to_), "");
  along_.direction_stddev = 0.0;
  EXPECT_NE(sign_.contradiction(along_, from_, to_), "") << "one of them has told the sign";
}

TEST_F(SignCheckOfAPush, isSettledByTheFirstTouchThatPushes) {
  EXPECT_EQ(sign_.contradiction(against_, from_, to_), "");
  EXPECT_EQ(sign_.contradiction(along_, from_, to_), "");
}

}  // namespace
}  // namespace smore
