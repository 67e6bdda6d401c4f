// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <optional>
#include <string>

namespace smore {

/// The safety mode in a message of the UR driver's type ur_dashboard_msgs/SafetyMode. Debian does
/// not have that package, so the message is taken as the one byte that it is on the wire; nothing
/// for a message of another size.
std::optional<std::uint8_t> safetyModeOf(const topic_tools::ShapeShifter& message);

/// Why an arm of Universal Robots in a safety mode (numbers of ur_dashboard_msgs/SafetyMode) does
/// not move; empty in the modes in which it does, normal (1) and reduced (2).
std::string safetyStop(std::uint8_t mode);

}  // namespace smore
