// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "sensor_feed.h"
#include "smore/contact/sample_rate.h"

namespace smore {
namespace {

TEST(SampleRate, isThePeriodOfASecondWhateverTheTiming) {
  for (const double period : {0.02, 0.008, 0.002, 0.001}) {
    FeedFaults faults;
    faults.jitter = 0.5;
    faults.late = 0.1;
    SensorFeed feed({}, period, faults, 207);
    SampleRate rate;
    for (int i = 0; i < 10; ++i) {
      for (const WrenchSample& sample : feed.next({})) rate.add(sample.time);
    }
    EXPECT_FALSE(rate.period()) << "before a second has passed";
    while (feed.time() < 3.0) {
      for (const WrenchSample& sample : feed.next({})) rate.add(sample.time);
    }
    ASSERT_TRUE(rate.period());
    EXPECT_NEAR(*rate.period() / period, 1.0, 0.1);
  }
}

TEST(SampleRate, knowsHowUnevenlySamplesCome) {
  SampleRate even, alternating;
  for (int i = 0; i < 2000; ++i) {
    const double late = i % 2 == 0 ? 0.0 : 0.0005;
    even.add(0.002 * i);
    alternating.add(0.002 * i + late);
  }
  ASSERT_TRUE(even.jitter() && alternating.jitter());
  EXPECT_NEAR(*even.jitter(), 0.0, 1e-8);
  EXPECT_NEAR(*alternating.jitter(), 0.0005, 1e-6);
}

TEST(SampleRate, isNotThatOfAGap) {
  SampleRate rate;
  double time = 0.0;
  for (int second = 0; second < 4; ++second) {
    for (int i = 0; i < 400; ++i) rate.add(time += 0.004);
    time += 7.0;
  }
  ASSERT_TRUE(rate.period());
  EXPECT_NEAR(*rate.period(), 0.004, 1e-9);
}

}  // namespace
}  // namespace smore
