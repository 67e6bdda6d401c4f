// SPDX-License-Identifier: BSD-3-Clause
// What a robot waits for while it stands.
#include "smore/ros/ros_robot.h"
#include "smore/ros/settle_deadline.h"

namespace smore {
namespace {

// The sensor says so by then where nothing touches and its tare has ended [s].
constexpr double kFreeWithin = 2.0;

}  // namespace

// A contact that is felt by now would neither end the motion nor set off the robot's own reflex.
bool RosRobot::pressesAtRest() {
  const double end = stamp() + kFreeWithin;
  bool free = false;
  waitUntil([&](const auto& observation) {
    free = observation.state == ContactState::kFree;
    return free || observation.time >= end;
  });
  return !free && press_.presses();
}

bool RosRobot::standStill(double duration) {
  const double end = stamp() + duration;
  return waitUntil([&](const auto& observation) { return observation.time >= end; });
}

bool RosRobot::waitUntilFree() {
  return waitUntil(
      [](const auto& observation) { return observation.state == ContactState::kFree; });
}

bool RosRobot::waitUntilAt(const Pose& target) {
  return waitUntil([&](const auto& observation) {
    return gapBetween(observation.T_world_object, target) < kAtTarget;
  });
}

bool RosRobot::waitUntil(const std::function<bool(const ContactObservation&)>& condition) {
  SettleDeadline deadline;
  bool fulfilled = false;
  stream_.open();
  while (const auto observation = nextObservation()) {
    fulfilled = condition(*observation);
    if (fulfilled || deadline.passedAt(observation->time)) break;
  }
  stream_.close();
  return fulfilled;
}

}  // namespace smore
