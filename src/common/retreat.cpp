// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/retreat.h"

namespace smore {
namespace {

constexpr int kMostStretches = 20;

}  // namespace

std::optional<MotionResult> retreatInStretches(const RetreatMoves& moves) {
  MotionResult result;
  for (int stretch = 0; stretch < kMostStretches; ++stretch) {
    const Path back = moves.way_back();
    if (!back.empty()) result = moves.go_back(back);
    if (result.end != MotionEnd::kReached || moves.becomes_free()) return result;
    if (back.empty()) break;
  }
  return std::nullopt;
}

}  // namespace smore
