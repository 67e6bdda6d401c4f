// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <ostream>

#include "smore/experiment/experiment.h"

namespace smore {

/// Shows the progress of an experiment: on a terminal one line with a bar that is drawn anew,
/// elsewhere a plain line for each finished trial.
class ProgressDisplay {
 public:
  /// `stream` must outlive this.
  ProgressDisplay(std::ostream* stream, bool terminal, int trials);

  void update(const ExperimentProgress& progress);

 private:
  void drawBar(const ExperimentProgress& progress);
  void printTrial(const ExperimentProgress& progress);

  std::ostream* stream_;
  bool terminal_;
  int trials_;
  int finished_ = 0;
  int succeeded_ = 0;
  std::chrono::steady_clock::time_point last_draw_;
};

}  // namespace smore
