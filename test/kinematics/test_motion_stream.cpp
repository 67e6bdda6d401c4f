// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "smore/kinematics/motion_stream.h"

namespace smore {
namespace {

constexpr double kPeriod = 0.002;
constexpr double kEnd = 1.0;

JointTrajectory motion() { return {{"joint"}, {{0.0, {0.0}, {0.0}}, {kEnd, {0.3}, {0.0}}}}; }

/// A controller: follows what it got last from the state that it was in, as fast as its slider
/// says.
class Controller {
 public:
  void take(const JointTrajectory& trajectory) {
    JointTrajectoryPoint now = state_;
    now.time = 0.0;
    points_ = {now};
    points_.insert(points_.end(), trajectory.points.begin(), trajectory.points.end());
    time_ = 0.0;
  }

  void advance(double scaling) {
    time_ += scaling * kPeriod;
    if (!points_.empty()) state_ = stateAt(points_, time_);
    speed_ = scaling * state_.velocities[0];
  }

  double position() const { return state_.positions[0]; }
  double speed() const { return speed_; }

 private:
  std::vector<JointTrajectoryPoint> points_;
  JointTrajectoryPoint state_{0.0, {0.0}, {0.0}};
  double time_ = 0.0;
  double speed_ = 0.0;
};

class MotionStreamTest : public ::testing::Test {
 protected:
  void SetUp() override { stream_.begin(motion()); }

  // For `duration` of the robot's clock; sends horizons or not.
  void run(double duration, double scaling = 1.0, bool sends = true) {
    for (int i = 0; i < std::lround(duration / kPeriod); ++i) {
      stamp_ += kPeriod;
      controller_.advance(scaling);
      if (!sends || !stream_.active()) continue;
      if (const auto horizon = stream_.advance(stamp_, scaling)) controller_.take(*horizon);
    }
  }

  // Where the motion is after `time` at full speed.
  static double along(double time) { return stateAt(motion().points, time).positions[0]; }

  MotionStream stream_{HorizonParameters{}};
  Controller controller_;
  double stamp_ = 1000.0;
};

TEST_F(MotionStreamTest, MovesTheRobotAlongTheMotionToItsEnd) {
  for (double time = kPeriod; time < 0.9; time += 0.1) {
    EXPECT_NEAR(controller_.position(), along(time - kPeriod), 2e-3) << time;
    run(0.1);
  }
  run(0.2);
  EXPECT_FALSE(stream_.active());
  EXPECT_DOUBLE_EQ(controller_.position(), 0.3);
}

TEST_F(MotionStreamTest, LeftAloneTheRobotStandsWithinAFifthOfASecond) {
  for (const double scaling : {1.0, 0.3, 0.1}) {
    stream_.begin(motion());
    controller_ = Controller();
    run(0.4 / scaling, scaling);
    EXPECT_GT(controller_.speed(), 0.2 * scaling);
    run(0.2, scaling, false);
    EXPECT_EQ(controller_.speed(), 0.0) << "at " << scaling;
  }
}

TEST_F(MotionStreamTest, ASlowRobotTakesLonger) {
  run(2.0, 0.2);
  EXPECT_NEAR(controller_.position(), along(0.4), 2e-3);
  run(3.2, 0.2);
  EXPECT_DOUBLE_EQ(controller_.position(), 0.3);
}

TEST_F(MotionStreamTest, APauseCostsNothing) {
  run(0.5);
  const double before = controller_.position();
  run(60.0, 0.0);
  EXPECT_EQ(controller_.position(), before);
  EXPECT_TRUE(stream_.active());
  run(0.6);
  EXPECT_DOUBLE_EQ(controller_.position(), 0.3);
}

TEST_F(MotionStreamTest, AClockThatStandsStillSendsNothing) {
  run(0.4);
  int sent = 0;
  for (int i = 0; i < 100; ++i) sent += stream_.advance(stamp_, 1.0) ? 1 : 0;
  EXPECT_LE(sent, 1);
  EXPECT_NEAR(stream_.expected().positions[0], along(0.4), 1e-3);
}

TEST_F(MotionStreamTest, AfterItsEndItIsSilent) {
  run(0.4);
  stream_.end();
  EXPECT_FALSE(stream_.active());
  run(0.2);
  EXPECT_EQ(controller_.speed(), 0.0);
  EXPECT_LT(controller_.position(), 0.2);
}

}  // namespace
}  // namespace smore
