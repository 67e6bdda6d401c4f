// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>

#include "smore/ros/leap_filter.h"

namespace smore {
namespace {

class LeapFilterTest : public ::testing::Test {
 protected:
  void take(double time) {
    geometry_msgs::WrenchStamped message;
    message.header.stamp = ros::Time(time);
    for (const auto& through : filter_.take(message)) {
      through_.push_back(through.header.stamp.toSec());
    }
  }

  void expectThrough(const std::vector<double>& times) {
    ASSERT_EQ(through_.size(), times.size());
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(through_[i], times[i], 1e-9);
  }

  LeapFilter<geometry_msgs::WrenchStamped> filter_;
  std::vector<double> through_;
};

TEST_F(LeapFilterTest, whatComesInOrderOrNearlySoIsLetThroughAtOnce) {
  for (const double time : {5.0, 5.002, 5.001, 5.9, 5.3}) take(time);
  expectThrough({5.0, 5.002, 5.001, 5.9, 5.3});
  EXPECT_EQ(filter_.dropped(), 0U);
}

TEST_F(LeapFilterTest, aLeapIsBelievedWhenTheNextOneFollows) {
  for (const double time : {5.0, 80.0, 80.002, 1.0}) take(time);
  expectThrough({5.0, 80.0, 80.002});
  take(1.002);
  expectThrough({5.0, 80.0, 80.002, 1.0, 1.002});
  EXPECT_EQ(filter_.dropped(), 0U);
}

TEST_F(LeapFilterTest, oneThatStraysIsDropped) {
  for (const double time : {5.0, 4294967294.0, 5.002, 0.0, 5.004}) take(time);
  expectThrough({5.0, 5.002, 5.004});
  EXPECT_EQ(filter_.dropped(), 2U);
}

TEST_F(LeapFilterTest, aSecondClockIsNotBelievedWhereItAlternates) {
  for (int i = 0; i < 10; ++i) {
    take(5.0 + 0.002 * i);
    take(3605.0 + 0.002 * i);
  }
  EXPECT_EQ(through_.size(), 10U);
  EXPECT_LT(through_.back(), 6.0);
}

TEST_F(LeapFilterTest, aSlowStreamWaitsOnceAndLosesNothing) {
  take(0.0);
  take(2.0);
  expectThrough({0.0});
  for (const double time : {4.1, 6.0, 9.0, 11.0}) take(time);
  expectThrough({0.0, 2.0, 4.1, 6.0, 9.0, 11.0});
  take(3600.0);
  take(13.0);
  expectThrough({0.0, 2.0, 4.1, 6.0, 9.0, 11.0, 13.0});
  EXPECT_EQ(filter_.dropped(), 1U);
}

TEST_F(LeapFilterTest, afterALeapALeapIsOneAgain) {
  for (const double time : {5.0, 80.0, 80.002, 9.0, 80.004}) take(time);
  expectThrough({5.0, 80.0, 80.002, 80.004});
  EXPECT_EQ(filter_.dropped(), 1U);
}

TEST_F(LeapFilterTest, oneThatNothingFollowsIsLetThroughAfterAWhile) {
  take(5.0);
  EXPECT_FALSE(filter_.overdue());
  take(80.0);
  const ros::WallTime begin = ros::WallTime::now();
  std::optional<geometry_msgs::WrenchStamped> overdue;
  while (!overdue) overdue = filter_.overdue();
  EXPECT_GE((ros::WallTime::now() - begin).toSec(), 0.9 * filter_.kPatience);
  EXPECT_NEAR(overdue->header.stamp.toSec(), 80.0, 1e-9);
  take(80.002);
  expectThrough({5.0, 80.002});
}

}  // namespace
}  // namespace smore
