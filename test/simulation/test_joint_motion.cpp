// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "smore/common/result.h"
#include "smore/simulation/joint_motion.h"

namespace smore {
namespace {

const std::vector<std::string> kNames{"a", "b"};

TEST(JointMotion, followsTheCubicBetweenPoints) {
  JointMotion motion(kNames, {0, 0});
  // a(t) = t^2 (3 - 2 t), b(t) = t: both are the cubic of their ends.
  motion.follow({kNames, {{0, {0, 0}, {0, 1}}, {1, {1, 1}, {0, 1}}}});
  for (int i = 1; i < 10; ++i) {
    motion.advance(0.1);
    const double t = 0.1 * i;
    EXPECT_TRUE(motion.moving());
    EXPECT_NEAR(motion.positions()[0], t * t * (3 - 2 * t), 1e-12);
    EXPECT_NEAR(motion.velocities()[0], 6 * t * (1 - t), 1e-12);
    EXPECT_NEAR(motion.positions()[1], t, 1e-12);
    EXPECT_NEAR(motion.velocities()[1], 1.0, 1e-12);
  }
  motion.advance(0.2);
  EXPECT_FALSE(motion.moving());
  EXPECT_EQ(motion.positions(), (std::vector<double>{1, 1}));
  EXPECT_EQ(motion.velocities(), (std::vector<double>{0, 0}));
}

TEST(JointMotion, takesJointsInAnyOrderAndStartsFromWhereTheyAre) {
  JointMotion motion(kNames, {1, 1});
  motion.follow({{"b", "a"}, {{1, {2, 4}, {}}}});
  motion.advance(0.5);
  EXPECT_EQ(motion.positions(), (std::vector<double>{2.5, 1.5}));
  EXPECT_EQ(motion.velocities(), (std::vector<double>{3, 1}));
}

TEST(JointMotion, stopsWhereItIsTold) {
  JointMotion motion(kNames, {0, 0});
  motion.follow({kNames, {{1, {1, 1}, {}}}});
  motion.advance(0.3);
  motion.stop({0.31, 0.29});
  EXPECT_FALSE(motion.moving());
  motion.advance(0.3);
  EXPECT_EQ(motion.positions(), (std::vector<double>{0.31, 0.29}));
}

// The cubic from 0 at 1 m/s to 1 at rest in 1 s: x = s + s^2 - s^3.
TEST(JointMotion, passesToANewMotionAsFastAsItIs) {
  JointMotion motion(kNames, {0, 0});
  motion.follow({kNames, {{1, {1, 1}, {}}}});
  motion.advance(0.25);
  motion.follow({kNames, {{1, {1.25, 1.25}, {0, 0}}}});
  EXPECT_EQ(motion.velocities(), (std::vector<double>{1, 1}));
  motion.advance(0.5);
  EXPECT_DOUBLE_EQ(motion.positions()[0], 0.25 + 0.5 + 0.25 - 0.125);
}

TEST(JointMotion, refusesWhatItCannotFollowAndGoesOn) {
  JointMotion motion(kNames, {0, 0});
  motion.follow({kNames, {{1, {1, 1}, {}}}});
  const std::vector<JointTrajectory> bad{
      {kNames, {}},
      {{"a"}, {{1, {1}, {}}}},
      {{"a", "c"}, {{1, {1, 1}, {}}}},
      {{"a", "a"}, {{1, {1, 1}, {}}}},
      {kNames, {{1, {1}, {}}}},
      {kNames, {{1, {1, 1}, {0}}}},
      {kNames, {{1, {1, std::nan("")}, {}}}},
      {kNames, {{1, {1, 1}, {}}, {1, {2, 2}, {}}}},
      {kNames, {{-1, {1, 1}, {}}}},
      {kNames, {{std::nan(""), {1, 1}, {}}}},
  };
  for (const JointTrajectory& trajectory : bad) {
    EXPECT_THROW(motion.follow(trajectory), InputError);
  }
  motion.advance(0.5);
  EXPECT_EQ(motion.positions(), (std::vector<double>{0.5, 0.5}));
}

}  // namespace
}  // namespace smore
