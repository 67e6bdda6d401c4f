// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/payload_tilts.h"

#include <std_srvs/Trigger.h>

#include "smore/contact/payload_identification.h"
#include "smore/ros/interruptible_call.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

// The listener averages half a second once the robot has stood for a quarter (StillPoses) [s].
constexpr double kStandTime = 1.0;

std::string standAt(RosRobot* robot, const Pose& tilted) {
  const Pose level = robot->pose();
  const MotionResult there = robot->follow({level, tilted});
  if (there.end == MotionEnd::kReached && !robot->standStill(kStandTime)) {
    return "no observations came while the robot stood";
  }
  if (there.end == MotionEnd::kFault || there.end == MotionEnd::kStopped) return there.reason;
  const MotionResult back = robot->retreat(gapBetween(robot->pose(), level));
  if (there.end == MotionEnd::kContact) {
    return "something touched; give the object room at the start, or tilt it less (payload_tilt); "
           "where something else is held than what was identified last, call "
           "force_torque/forget_payload while it hangs free";
  }
  if (there.end == MotionEnd::kUnreachable) return there.reason;
  return back.end == MotionEnd::kReached ? "" : back.reason;
}

}  // namespace

std::string identifyPayloadByTilting(RosRobot* robot, ros::NodeHandle* node, double tilt) {
  const std::string failed = "the payload is not identified: ";
  if (!robot->standStill(kStandTime)) return failed + "no observations came while the robot stood";
  for (const Pose& tilted : payloadTilts(robot->pose(), tilt)) {
    const std::string problem = standAt(robot, tilted);
    if (!problem.empty()) return failed + problem;
  }
  // The listener refuses while the robot moves, which has hardly come back.
  if (!robot->standStill(kStandTime)) return failed + "no observations came while the robot stood";
  ros::ServiceClient identify =
      node->serviceClient<std_srvs::Trigger>(names::kListenerIdentifyPayload);
  std_srvs::Trigger call;
  const auto given_up = [robot] { return robot->stopRequested(); };
  if (!callInterruptibly(identify, &call, given_up))
    call.response.message = "'" + identify.getService() + "' fails";
  return call.response.success != 0 ? "" : failed + call.response.message;
}

}  // namespace smore
