// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <sstream>

#include "smore/experiment/progress_display.h"

namespace smore {
namespace {

ExperimentProgress finishedTrial() {
  ExperimentProgress progress;
  progress.seed = 7;
  progress.collisions = 12;
  progress.plans = 13;
  progress.finished = true;
  progress.success = true;
  progress.reason = "the object is at the goal";
  return progress;
}

TEST(ProgressDisplay, printsPlainLinesOffATerminal) {
  std::ostringstream stream;
  ProgressDisplay display(&stream, false, 2);
  display.update({});
  display.update(finishedTrial());
  EXPECT_EQ(stream.str(), "seed 7: the object is at the goal after 12 collisions, 13 plans\n");
}

TEST(ProgressDisplay, drawsABarOnATerminal) {
  std::ostringstream stream;
  ProgressDisplay display(&stream, true, 2);
  display.update(finishedTrial());
  EXPECT_NE(stream.str().find("1/2 trials, 1 at the goal"), std::string::npos);
  EXPECT_NE(stream.str().find("[###############...............]"), std::string::npos);
}

}  // namespace
}  // namespace smore
