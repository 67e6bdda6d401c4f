// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/common/geometry.h"

namespace smore {

/// The largest distance at which a tool may be seen from where joints and description have it: what
/// calibrations leave is a third of it [m].
constexpr double kMostToolGap = 0.01;
/// The same of its orientation [rad].
constexpr double kMostToolTurn = 0.05;

/// Why no motion may begin where the tool is seen at T_tool_seen (JointCommands::toolGap), with the
/// offset and the remedy; empty where it may.
std::string toolGapProblem(const Pose& T_tool_seen);

}  // namespace smore
