// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/ros/retrieval_summary.h"

namespace smore {
namespace {

TEST(RetrievalSummary, SaysHowItEndedInItsFirstWord) {
  RetrievalSummary summary;
  summary.outcome.reason = "why";
  EXPECT_EQ(toText(summary).find("FAILED: why"), 0U);
  summary.cancelled = true;
  EXPECT_EQ(toText(summary).find("CANCELLED: why"), 0U);
  summary.cancelled = false;
  summary.outcome.success = true;
  EXPECT_EQ(toText(summary).find("SUCCESS: why"), 0U);
}

}  // namespace
}  // namespace smore
