// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "smore/common/robot.h"

namespace smore {

/// Why a retreat was given up, for the user.
constexpr char kStillInContact[] = "still in contact after the retreat";

/// What a robot retreats by.
struct RetreatMoves {
  std::function<Path()> way_back;  ///< from where it is; empty where it is back at the beginning
  std::function<MotionResult(const Path& back)> go_back;  ///< asked for ways that are not empty
  std::function<bool()> becomes_free;  ///< stands still until nothing touches; false if that lasts
};

/// Goes back in stretches: on where it was stopped, and on while something still touches. How the
/// last stretch ended, which is kReached where nothing touches; nothing where something touches
/// back at the beginning too, or after many stretches.
std::optional<MotionResult> retreatInStretches(const RetreatMoves& moves);

}  // namespace smore
