// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/common/geometry.h"

namespace smore {

/// How far a tool may be seen from where joints and description have it.
struct ToolGapLimits {
  double distance;  ///< [m]
  double angle;     ///< [rad]
};

/// Where the description is the maker's table: what calibrations leave is a third of it.
constexpr ToolGapLimits kNominalToolGap = {0.01, 0.05};
/// Where it carries the arm's calibration, by which the controller has its tool to a tenth of it;
/// what is left is a TCP. A choice: as near as motions arrive.
constexpr ToolGapLimits kCalibratedToolGap = {0.002, 0.01};

/// Why no motion may begin where the tool is seen at T_tool_seen (JointCommands::toolGap), with the
/// offset and the remedy; empty where it may. `description`: where that of the arm comes from.
std::string toolGapProblem(const Pose& T_tool_seen, const ToolGapLimits& limits,
                           const std::string& description);

}  // namespace smore
