// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/progress_display.h"

#include <string>

namespace smore {
namespace {

constexpr int kBarWidth = 30;
constexpr std::chrono::milliseconds kRedrawPeriod{100};
constexpr const char* kEraseLine = "\r\x1b[K";

}  // namespace

ProgressDisplay::ProgressDisplay(std::ostream* stream, bool terminal, int trials)
    : stream_(stream), terminal_(terminal), trials_(trials) {}

void ProgressDisplay::update(const ExperimentProgress& progress) {
  if (progress.finished) {
    ++finished_;
    if (progress.success) ++succeeded_;
    printTrial(progress);
  }
  if (terminal_ && finished_ < trials_) drawBar(progress);
}

void ProgressDisplay::drawBar(const ExperimentProgress& progress) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_draw_ < kRedrawPeriod) return;
  last_draw_ = now;
  const int filled = kBarWidth * finished_ / trials_;
  *stream_ << kEraseLine << "[" << std::string(filled, '#') << std::string(kBarWidth - filled, '.')
           << "] " << finished_ << "/" << trials_ << " trials, " << succeeded_
           << " at the goal; seed " << progress.seed << ": " << progress.plans << " plans, "
           << progress.collisions << " collisions" << std::flush;
}

void ProgressDisplay::printTrial(const ExperimentProgress& progress) {
  if (terminal_) *stream_ << kEraseLine;
  *stream_ << "seed " << progress.seed << ": " << progress.reason << " after "
           << progress.collisions << " collisions, " << progress.plans << " plans" << std::endl;
}

}  // namespace smore
