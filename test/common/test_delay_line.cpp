// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/common/delay_line.h"

namespace smore {
namespace {

TEST(DelayLine, GivesEachThingWhenItHasArrived) {
  DelayLine<int> line;
  line.push(1.0, 1);
  line.push(2.0, 2);
  EXPECT_FALSE(line.pop(0.9));
  EXPECT_EQ(line.pop(1.0), 1);
  EXPECT_FALSE(line.pop(1.9));
  EXPECT_EQ(line.pop(5.0), 2);
  EXPECT_FALSE(line.pop(5.0));
}

TEST(DelayLine, KeepsTheOrderOfWhatWouldOvertake) {
  DelayLine<int> line;
  line.push(2.0, 1);
  line.push(1.0, 2);
  EXPECT_FALSE(line.pop(1.5));
  EXPECT_EQ(line.pop(2.0), 1);
  EXPECT_EQ(line.pop(2.0), 2);
}

}  // namespace
}  // namespace smore
