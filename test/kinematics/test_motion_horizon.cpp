// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "smore/kinematics/motion_horizon.h"

namespace smore {
namespace {

const std::vector<std::string> kJoints = {"shoulder", "elbow"};

// At constant speed through many points, with a cubic to rest at each end.
JointTrajectory cruise() {
  JointTrajectory motion{kJoints, {{0.0, {0.0, 0.0}, {0.0, 0.0}}}};
  for (int i = 0; i <= 30; ++i) {
    motion.points.push_back({0.1 + 0.03 * i, {0.02 + 0.006 * i, -0.01 - 0.003 * i}, {0.2, -0.1}});
  }
  motion.points.push_back({1.1, {0.22, -0.11}, {0.0, 0.0}});
  return motion;
}

// What a joint trajectory controller does that gets the trajectory in state `now`.
std::vector<JointTrajectoryPoint> followed(const JointTrajectoryPoint& now,
                                           const JointTrajectory& trajectory) {
  std::vector<JointTrajectoryPoint> points{{0.0, now.positions, now.velocities}};
  points.insert(points.end(), trajectory.points.begin(), trajectory.points.end());
  return points;
}

// Closed form: v^2 / (2 a) for the fastest joint, the others in the same time.
TEST(Brake, stopsAtConstantDeceleration) {
  const JointTrajectoryPoint now{7.0, {1.0, -1.0}, {0.6, -0.3}};
  const JointTrajectory stop = brake(kJoints, now, 15.0, 1.0);
  ASSERT_EQ(stop.points.size(), 1U);
  EXPECT_DOUBLE_EQ(stop.points[0].time, 0.04);
  EXPECT_DOUBLE_EQ(stop.points[0].positions[0], 1.0 + 0.6 * 0.6 / (2.0 * 15.0));
  EXPECT_DOUBLE_EQ(stop.points[0].positions[1], -1.0 - 0.5 * 0.04 * 0.3);
  EXPECT_EQ(stop.points[0].velocities, std::vector<double>({0.0, 0.0}));
  const auto path = followed(now, stop);
  for (const double time : {0.01, 0.02, 0.03}) {
    EXPECT_NEAR(stateAt(path, time).velocities[0], 0.6 - 15.0 * time, 1e-12);
  }
}

TEST(Brake, ofARobotAtRestKeepsItWhereItIs) {
  const JointTrajectory stop = brake(kJoints, {0.0, {1.0, -1.0}, {0.0, 0.0}}, 15.0, 1.0);
  EXPECT_EQ(stop.points.back().positions, std::vector<double>({1.0, -1.0}));
  EXPECT_GT(stop.points.back().time, 0.0);
}

// A robot at a tenth of its speed runs through trajectories ten times as slowly.
TEST(Brake, takesTheSameTimeAndWayAtAnySliderSetting) {
  const JointTrajectoryPoint now{0.0, {1.0, -1.0}, {0.06, -0.03}};
  for (const double scaling : {1.0, 0.5, 0.1}) {
    const JointTrajectoryPoint rest = brake(kJoints, now, 1.5, scaling).points.back();
    EXPECT_NEAR(rest.time / scaling, 0.04, 1e-12);
    EXPECT_NEAR(rest.positions[0], 1.0 + 0.06 * 0.06 / (2.0 * 1.5), 1e-12);
  }
}

TEST(Brake, ofAPausedRobotIsFinite) {
  const JointTrajectoryPoint rest =
      brake(kJoints, {0.0, {1.0, -1.0}, {0.0, 0.0}}, 15.0, 0.0).points.back();
  EXPECT_GT(rest.time, 0.0);
  EXPECT_EQ(rest.positions, std::vector<double>({1.0, -1.0}));
}

TEST(Horizon, followsTheMotionAndThenBrakes) {
  const JointTrajectory motion = cruise();
  HorizonParameters parameters;
  parameters.deceleration = 4.0;  // the brake is longer than the shortest
  const JointTrajectory horizon = horizonOf(motion, 0.35, 1.0, parameters);
  const auto path = followed(stateAt(motion.points, 0.35), horizon);
  for (double time = 0.0; time < parameters.duration; time += 0.003) {
    const JointTrajectoryPoint state = stateAt(path, time);
    const JointTrajectoryPoint wanted = stateAt(motion.points, 0.35 + time);
    for (const size_t joint : {0, 1}) {
      EXPECT_NEAR(state.positions[joint], wanted.positions[joint], 1e-9);
      EXPECT_NEAR(state.velocities[joint], wanted.velocities[joint], 1e-9);
    }
  }
  const JointTrajectoryPoint& last = horizon.points.back();
  EXPECT_NEAR(last.time, parameters.duration + 0.2 / parameters.deceleration, 1e-9);
  EXPECT_EQ(last.velocities, std::vector<double>({0.0, 0.0}));
  EXPECT_LT(last.time, 0.2) << "a robot that is left alone stands";
}

TEST(Horizon, isAsLongOnTheWallAtAnySliderSetting) {
  for (const double scaling : {0.5, 0.1, kLeastScaling}) {
    const JointTrajectory horizon = horizonOf(cruise(), 0.35, scaling, {});
    const JointTrajectoryPoint& brake_begins = horizon.points[horizon.points.size() - 2];
    EXPECT_NEAR(brake_begins.time / scaling, 0.12, 1e-9);
    EXPECT_NEAR(horizon.points.front().time / scaling, 0.04, 1e-9);
    EXPECT_LT(horizon.points.back().time / scaling, 0.2);
  }
}

TEST(Horizon, endsWithTheMotion) {
  const JointTrajectory motion = cruise();
  for (const double before : {0.119, 0.05, 0.04, 0.02, 1e-4}) {
    const JointTrajectory horizon = horizonOf(motion, 1.1 - before, 1.0, {});
    EXPECT_EQ(horizon.points.back().positions, motion.points.back().positions);
    EXPECT_NEAR(horizon.points.back().time, before, 1e-9);
  }
}

// The controller may be some milliseconds elsewhere than this thinks.
TEST(Horizon, isTakenUpSmoothlyByARobotThatIsElsewhere) {
  const JointTrajectory motion = cruise();
  const JointTrajectory horizon = horizonOf(motion, 0.35, 1.0, {});
  for (const double off : {-0.01, -0.005, 0.005, 0.01}) {
    const auto path = followed(stateAt(motion.points, 0.35 + off), horizon);
    for (double time = 0.0; time < 0.12; time += 0.001) {
      EXPECT_LT(std::abs(stateAt(path, time).velocities[0] - 0.2), 0.08);
    }
  }
}

TEST(Horizon, hasRisingTimesWhereverItIsCut) {
  const JointTrajectory motion = cruise();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> cut(0.0, 1.0);
  for (int i = 0; i < 10000; ++i) {
    // Now and then at, or next to, a point of the motion.
    double time = 1.0999 * cut(random);
    if (i % 3 == 0) time = 0.1 + 0.03 * (i % 30) + (i % 2) * 1e-13;
    const double scaling = i % 5 == 0 ? 1.0 : kLeastScaling + (1.0 - kLeastScaling) * cut(random);
    double before = 0.0;
    for (const JointTrajectoryPoint& point : horizonOf(motion, time, scaling, {}).points) {
      ASSERT_GT(point.time, before) << time << " at " << scaling;
      before = point.time;
    }
  }
}

}  // namespace
}  // namespace smore
