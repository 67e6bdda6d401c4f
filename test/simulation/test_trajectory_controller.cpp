// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "smore/simulation/trajectory_controller.h"

namespace smore {
namespace {

constexpr double kStep = 0.002;
constexpr double kStop = 0.5;  // the driver's own setting [s]
const std::vector<std::string> kNames = {"a", "b"};

// At 0.2 and -0.1 rad/s, for ten seconds.
JointTrajectory cruise() { return {kNames, {{10.0, {2.0, -1.0}, {0.2, -0.1}}}}; }

class TrajectoryControllerTest : public ::testing::Test {
 protected:
  void run(double duration, double scaling = 1.0) {
    for (int i = 0; i < std::lround(duration / kStep); ++i) controller_.advance(kStep, scaling);
  }

  // A motion that has come to its constant velocity.
  void setOff() {
    controller_.command(
        {kNames, {{0.1, {0.0, 0.0}, {0.2, -0.1}}, {10.1, {2.0, -1.0}, {0.2, -0.1}}}});
    run(0.2);
    ASSERT_NEAR(controller_.velocities()[0], 0.2, 1e-12);
  }

  TrajectoryController controller_{kNames, {0.0, 0.0}, kStop};
};

TEST_F(TrajectoryControllerTest, StopsOverThreeTenthsOfASecondTimesItsVelocity) {
  setOff();
  const std::vector<double> begin = controller_.positions();
  controller_.command({});
  run(kStop - 0.1);
  EXPECT_GT(controller_.velocities()[0], 0.0);
  run(0.1);
  EXPECT_NEAR(controller_.velocities()[0], 0.0, 1e-12);
  EXPECT_NEAR(controller_.positions()[0] - begin[0], 0.3125 * 0.2, 1e-12);
  EXPECT_NEAR(controller_.positions()[1] - begin[1], -0.3125 * 0.1, 1e-12);
  run(1.0);
  EXPECT_NEAR(controller_.positions()[0] - begin[0], 0.3125 * 0.2, 1e-12);
}

TEST_F(TrajectoryControllerTest, ItsRampsVelocityIsTheSlopeOfItsPosition) {
  setOff();
  controller_.command({});
  for (double time = 0.01; time < kStop; time += 0.02) {
    const double before = controller_.positions()[0];
    const double v0 = controller_.velocities()[0];
    run(0.02);
    const double mean = (controller_.positions()[0] - before) / 0.02;
    EXPECT_NEAR(mean, 0.5 * (v0 + controller_.velocities()[0]), 5e-4);
  }
}

// The slider does not shorten the way, it lengthens the time.
TEST_F(TrajectoryControllerTest, TheSliderScalesTheTimeOfTheRampAndNotItsWay) {
  setOff();
  const double begin = controller_.positions()[0];
  controller_.command({});
  run(4.9, 0.1);
  EXPECT_GT(controller_.velocities()[0], 0.0);
  run(0.1, 0.1);
  EXPECT_NEAR(controller_.positions()[0] - begin, 0.3125 * 0.2, 1e-12);
}

TEST_F(TrajectoryControllerTest, ASecondStopBeginsTheRampAnew) {
  setOff();
  controller_.command({});
  run(0.2);
  const double v = controller_.velocities()[0];
  const double begin = controller_.positions()[0];
  controller_.command({});
  run(0.4);
  EXPECT_GT(controller_.velocities()[0], 0.0);
  run(0.1);
  EXPECT_NEAR(controller_.positions()[0] - begin, 0.3125 * v, 1e-12);
}

TEST_F(TrajectoryControllerTest, ANewTrajectoryTakesOverWithoutAJump) {
  setOff();
  const double begin = controller_.positions()[0];
  controller_.command({kNames, {{0.5, {begin + 0.1, -1.0}, {0.0, 0.0}}}});
  double last = begin;
  double last_velocity = 0.2;
  for (int i = 0; i < 250; ++i) {
    run(kStep);
    EXPECT_LT(std::abs(controller_.positions()[0] - last), 0.5 * kStep);
    EXPECT_LT(std::abs(controller_.velocities()[0] - last_velocity), 5.0 * kStep);
    last = controller_.positions()[0];
    last_velocity = controller_.velocities()[0];
  }
  EXPECT_NEAR(controller_.positions()[0], begin + 0.1, 1e-12);
}

TEST_F(TrajectoryControllerTest, APointInThePastIsSkippedWithoutAWord) {
  controller_.command({kNames, {{0.0, {5.0, 5.0}, {0.0, 0.0}}}});
  run(0.1);
  EXPECT_EQ(controller_.positions(), std::vector<double>({0.0, 0.0}));
  controller_.command({kNames, {{-1.0, {5.0, 5.0}, {}}, {1.0, {1.0, 1.0}, {0.0, 0.0}}}});
  run(0.5);
  EXPECT_NEAR(controller_.positions()[0], 0.5, 1e-12);
}

TEST_F(TrajectoryControllerTest, ThePaceIsTheSliders) {
  controller_.command({kNames, {{1.0, {1.0, 1.0}, {}}}});
  run(1.0, 0.3);
  EXPECT_NEAR(controller_.positions()[0], 0.3, 1e-12);
  run(60.0, 0.0);
  EXPECT_NEAR(controller_.positions()[0], 0.3, 1e-12);
  run(0.7);
  EXPECT_NEAR(controller_.positions()[0], 1.0, 1e-12);
}

TEST_F(TrajectoryControllerTest, AStoppedOneDropsCommandsAndBeginsAtRest) {
  setOff();
  controller_.stop();
  const std::vector<double> there = controller_.positions();
  controller_.command(cruise());
  run(1.0);
  EXPECT_EQ(controller_.positions(), there);
  controller_.start({0.5, 0.5});
  run(1.0);
  EXPECT_EQ(controller_.positions(), std::vector<double>({0.5, 0.5}));
  EXPECT_EQ(controller_.velocities(), std::vector<double>({0.0, 0.0}));
}

TEST_F(TrajectoryControllerTest, WhatIsNoTrajectoryOfItsJointsIsDropped) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  controller_.command({{"a", "c"}, {{1.0, {1.0, 1.0}, {}}}});
  controller_.command({{"a"}, {{1.0, {1.0}, {}}}});
  controller_.command({kNames, {{1.0, {1.0}, {}}}});
  controller_.command({kNames, {{1.0, {1.0, nan}, {}}}});
  controller_.command({kNames, {{nan, {1.0, 1.0}, {}}}});
  run(2.0);
  EXPECT_EQ(controller_.positions(), std::vector<double>({0.0, 0.0}));
  controller_.command({{"b", "a"}, {{1.0, {1.0, 2.0}, {}}}});
  run(1.0);
  EXPECT_EQ(controller_.positions(), std::vector<double>({2.0, 1.0}));
}

}  // namespace
}  // namespace smore
