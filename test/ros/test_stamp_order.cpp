// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "smore/ros/stamp_order.h"

namespace smore {
namespace {

using Verdict = StampOrder::Verdict;

TEST(StampOrder, StampsThatRiseAreNew) {
  StampOrder order;
  for (const double time : {100.0, 100.002, 100.004, 101.0}) {
    EXPECT_EQ(order.add(ros::Time(time)), Verdict::kNew) << time;
  }
  EXPECT_EQ(order.newest(), ros::Time(101.0));
}

TEST(StampOrder, ARepeatedOrLateOneIsNot) {
  StampOrder order;
  order.add(ros::Time(100.0));
  for (const double time : {100.0, 99.9, 99.1}) {
    EXPECT_EQ(order.add(ros::Time(time)), Verdict::kRepeated) << time;
  }
  EXPECT_EQ(order.add(ros::Time(100.1)), Verdict::kNew);
}

// Of an hour ahead, of the beginning of time, and the last that there is.
TEST(StampOrder, ASingleWrongOneSetsNoTime) {
  for (const ros::Time& wrong :
       {ros::Time(3700.0), ros::Time(), ros::Time(std::numeric_limits<std::uint32_t>::max(), 0)}) {
    StampOrder order;
    order.add(ros::Time(100.0));
    EXPECT_EQ(order.add(wrong), Verdict::kDoubtful) << wrong;
    EXPECT_EQ(order.add(ros::Time(100.002)), Verdict::kNew) << wrong;
    EXPECT_EQ(order.add(ros::Time(100.001)), Verdict::kRepeated) << wrong;
  }
}

TEST(StampOrder, AJumpIsBelievedWhereTheNextOneGoesOn) {
  StampOrder forward;
  forward.add(ros::Time(100.0));
  EXPECT_EQ(forward.add(ros::Time(110.0)), Verdict::kDoubtful);
  EXPECT_EQ(forward.add(ros::Time(110.002)), Verdict::kNew);
  EXPECT_EQ(forward.add(ros::Time(110.004)), Verdict::kNew);

  StampOrder back;
  back.add(ros::Time(100.0));
  EXPECT_EQ(back.add(ros::Time(10.0)), Verdict::kDoubtful);
  EXPECT_EQ(back.add(ros::Time(10.002)), Verdict::kWentBack);
  EXPECT_EQ(back.add(ros::Time(10.004)), Verdict::kNew);
}

// Neither confirms the other.
TEST(StampOrder, WrongOnesOnBothSidesAreDoubtful) {
  StampOrder order;
  order.add(ros::Time(100.0));
  EXPECT_EQ(order.add(ros::Time(1.0)), Verdict::kDoubtful);
  EXPECT_EQ(order.add(ros::Time(900.0)), Verdict::kDoubtful);
  EXPECT_EQ(order.add(ros::Time(2.0)), Verdict::kDoubtful);
  EXPECT_EQ(order.add(ros::Time(100.1)), Verdict::kNew);
}

// However slow a stream is, what it says counts from its third message on.
TEST(StampOrder, ASlowStreamIsTaken) {
  StampOrder order;
  int taken = 0;
  for (int i = 0; i < 10; ++i) taken += order.add(ros::Time(100.0 + 5.0 * i)) == Verdict::kNew;
  EXPECT_GE(taken, 5);
}

}  // namespace
}  // namespace smore
