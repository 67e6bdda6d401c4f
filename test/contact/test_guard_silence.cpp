// SPDX-License-Identifier: BSD-3-Clause
#include "guarded_robot.h"

namespace smore {
namespace {

class GuardSilenceTest : public MotionGuardTest {};

TEST_F(GuardSilenceTest, SilenceOfEitherStreamLatchesAfterItsTime) {
  run(0.2, false, true);
  EXPECT_EQ(guard_.fault(), "");
  run(2 * kPeriod, false, true);
  EXPECT_NE(guard_.fault().find("no wrench younger than 200 ms"), std::string::npos);
  guard_.clear(now_);
  EXPECT_NE(guard_.fault(), "") << "still silent";
  run(kPeriod);
  guard_.clear(now_);
  EXPECT_EQ(guard_.fault(), "");
  run(0.2 + 2 * kPeriod, true, false);
  EXPECT_NE(guard_.fault().find("no joint states younger than 200 ms"), std::string::npos);
}

TEST_F(GuardSilenceTest, ARepeatedMessageIsSilence) {
  for (int i = 0; i < 110; ++i) {
    now_ += kPeriod;
    guard_.onWrench(now_, 1.0, wrench_);
    guard_.onJoints(now_, {now_, kJoints, positions_, velocities_});
    guard_.onContact(now_, now_, true);
    guard_.check(now_);
  }
  EXPECT_NE(guard_.fault().find("no wrench younger"), std::string::npos) << guard_.fault();
}

// They come as often as they should.
TEST_F(GuardSilenceTest, MessagesOfLongAgoAreSilence) {
  const auto run_late = [&](double wrench_age, double joints_age) {
    for (int i = 0; i < 5; ++i) {
      now_ += kPeriod;
      guard_.onWrench(now_ - wrench_age, now_, wrench_);
      guard_.onJoints(now_ - joints_age, {now_, kJoints, positions_, velocities_});
      guard_.onContact(now_, now_, true);
      guard_.check(now_);
    }
  };
  run_late(0.19, 0.19);
  EXPECT_EQ(guard_.fault(), "");
  run_late(0.21, 0.19);
  EXPECT_NE(guard_.fault().find("no wrench younger"), std::string::npos) << guard_.fault();
  run_late(0.19, 0.21);
  guard_.clear(now_);
  EXPECT_NE(guard_.fault().find("no joint states younger"), std::string::npos) << guard_.fault();
}

// As of a driver that has lost its robot; one of the six values is enough to show that it has not.
TEST_F(GuardSilenceTest, AWrenchThatStaysTheSameUnderFreshStampsLatchesAtRest) {
  parameters_.wrench_varies = true;
  guard_ = MotionGuard(parameters_, kJoints);
  for (int i = 0; i < 100; ++i) {
    wrench_.torque.z() = 1e-3 * (i % 2 + 1);
    run(kPeriod);
  }
  EXPECT_EQ(guard_.fault(), "");
  run(0.198);
  EXPECT_EQ(guard_.fault(), "");
  run(2 * kPeriod);
  EXPECT_NE(guard_.fault().find("has been the same for over 200 ms"), std::string::npos);
  guard_.clear(now_);
  EXPECT_NE(guard_.fault(), "") << "frozen still";
  wrench_.force.x() += 0.1;
  run(kPeriod);
  guard_.clear(now_);
  EXPECT_EQ(guard_.fault(), "");
}

TEST_F(GuardSilenceTest, ContactObservationsThatStayOutLatchAtRest) {
  run(0.19, true, true, false);
  EXPECT_EQ(guard_.fault(), "");
  run(0.02, true, true, false);
  EXPECT_NE(guard_.fault().find("contact observations are late"), std::string::npos);
}

TEST_F(GuardSilenceTest, ContactObservationsOfLongAgoLatchAtRest) {
  for (int i = 0; i < 5; ++i) {
    run(kPeriod, true, true, false);
    guard_.onContact(now_, now_ - 0.21, true);
  }
  guard_.check(now_);
  EXPECT_NE(guard_.fault().find("contact observations are late"), std::string::npos);
}

// As where the guard itself was held up: it hears one stream after the other.
TEST_F(GuardSilenceTest, ObservationsThatAreHandedOverAfterTheirWrenchesDoNotLatch) {
  const double before = now_;
  now_ += 0.5;
  guard_.onWrench(now_, now_, wrench_);
  guard_.onJoints(now_, {now_, kJoints, positions_, velocities_});
  guard_.check(before + kPeriod);
  guard_.check(before + kPeriod);
  EXPECT_EQ(guard_.fault(), "");
  guard_.onContact(now_, now_, true);
  guard_.check(now_);
  EXPECT_EQ(guard_.fault(), "");
  run(0.21, true, true, false);
  EXPECT_NE(guard_.fault().find("contact observations are late"), std::string::npos);
}

// By their stamps, which are those of their wrenches, where the clocks differ.
TEST_F(GuardSilenceTest, ObservationsThatAreBehindTheirWrenchesLatch) {
  const auto ahead = [&](double lag) {
    now_ += kPeriod;
    guard_.onWrench(now_, now_ + 1.0, wrench_);
    guard_.onJoints(now_, {now_ + 1.0, kJoints, positions_, velocities_});
    guard_.onContact(now_, now_ + 1.0 - lag, true);
    guard_.check(now_);
  };
  for (int i = 0; i < 10; ++i) ahead(0.19);
  EXPECT_EQ(guard_.fault(), "");
  for (int i = 0; i < 3; ++i) ahead(0.21);
  EXPECT_NE(guard_.fault().find("contact observations are late"), std::string::npos);
}

// As of a listener on a busy machine, before it has tared.
TEST(GuardSilence, ObservationsThatAreUnevenAtTheStartDoNotLatch) {
  MotionGuard guard({}, {"joint"});
  const auto wrench_at = [&](double time) {
    guard.onWrench(time, time, {});
    guard.onJoints(time, {time, {"joint"}, {0.0}, {0.0}});
    guard.check(time);
  };
  wrench_at(0.0);
  guard.onContact(0.0, 0.0, false);
  for (int i = 1; i <= 200; ++i) wrench_at(kPeriod * i);
  EXPECT_EQ(guard.fault(), "");
  EXPECT_FALSE(guard.admit(kPeriod * 200, {{"joint"}, {{1.0, {0.0}, {}}}})) << "it is not felt yet";
  guard.clear(kPeriod * 200);
  guard.onContact(kPeriod * 200, kPeriod * 200, true);
  guard.onContact(kPeriod * 201, kPeriod * 201, false);  // it counts from now on, sure or not
  for (int i = 201; i <= 310; ++i) wrench_at(kPeriod * i);
  EXPECT_NE(guard.fault().find("contact observations are late"), std::string::npos);
}

}  // namespace
}  // namespace smore
