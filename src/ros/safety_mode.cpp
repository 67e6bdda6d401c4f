// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/safety_mode.h"

#include <array>

namespace smore {
namespace {

constexpr std::uint8_t kReduced = 2;  // the last mode in which it moves
constexpr std::array<const char*, 14> kNames = {"unknown",
                                                "normal",
                                                "reduced",
                                                "protective stop",
                                                "recovery",
                                                "safeguard stop",
                                                "system emergency stop",
                                                "robot emergency stop",
                                                "violation",
                                                "fault",
                                                "validate joint id",
                                                "undefined",
                                                "automatic mode safeguard stop",
                                                "three position enabling stop"};

}  // namespace

std::optional<std::uint8_t> safetyModeOf(const topic_tools::ShapeShifter& message) {
  if (message.size() != 1) return std::nullopt;
  std::uint8_t mode = 0;
  ros::serialization::OStream stream(&mode, 1);
  message.write(stream);
  return mode;
}

std::string safetyStop(std::uint8_t mode) {
  if (mode >= 1 && mode <= kReduced) return "";
  const std::string name = mode < kNames.size() ? kNames.at(mode) : kNames.front();
  return "the robot's safety mode is " + std::to_string(mode) + " (" + name +
         "); the pendant says more";
}

}  // namespace smore
