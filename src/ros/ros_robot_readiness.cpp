// SPDX-License-Identifier: BSD-3-Clause
// What a robot lacks before its first motion.
#include "smore/ros/ros_robot.h"
#include "smore/ros/sensor_zero.h"

namespace smore {

std::string RosRobot::waitUntilReady() {
  if (fault_place_.isZeroed()) {
    return "the robot's program was started while the object pressed, which zeroes the sensor of a "
           "UR: what presses is no longer felt; move the object free by hand or by the pendant, by "
           "1 cm at least, zero the sensor there by its driver (zero_ftsensor), then send the goal "
           "again";
  }
  if (!parameters_.zero_service.empty() && !fault_place_.isHere()) {
    std::string problem = zeroSensor(&node_, parameters_.zero_service, parameters_.ready_timeout,
                                     [this] { return stopRequested(); });
    if (!problem.empty()) return problem;
  }
  stream_.open();
  const ros::WallTime deadline =
      ros::WallTime::now() + ros::WallDuration(parameters_.ready_timeout);
  std::string missing = "no contact observations on '" + contact_.getTopic() +
                        "'; is the force_torque node up, and does it get wrenches and transforms?";
  std::string fault = guardFault();
  while (ros::ok() && ros::WallTime::now() < deadline && !missing.empty() && fault.empty() &&
         !stop_requested_) {
    const auto observation = stream_.next(kLookPeriod);
    if (observation) missing = missingBeside(*observation);
    fault = guardFault();
  }
  stream_.close();
  if (!fault.empty()) return fault;
  return missing.empty() ? toolProblem() : missing;
}

std::string RosRobot::missingBeside(const ContactObservation& observation) {
  if (observation.state == ContactState::kContact) {
    return "the object presses against something; move it free, then tare the sensor";
  }
  if (observation.state != ContactState::kFree) {
    return "the sensor never says that the object is free; have it tared (force_torque/tare) where "
           "it may have drifted, and look at the force_torque node's log";
  }
  if (command_.getNumSubscribers() == 0) {
    return "nobody listens to commands on '" + command_.getTopic() + "'; is the robot up?";
  }
  if (const auto joints = joints_.positionsAt(stamp()); !joints) return joints.reason();
  if (!parameters_.reset_service.empty() && !reset_.exists()) {
    return "the service '" + reset_.getService() + "' does not appear; is the robot up?";
  }
  return "";
}

std::string RosRobot::toolProblem() const {
  const Result<std::vector<double>> joints = joints_.positionsAt(stamp());
  if (!joints) return joints.reason();
  const std::optional<Pose> T_tool_seen = commands_->toolGap(*joints, pose());
  if (!T_tool_seen) return "";
  const double gap = T_tool_seen->translation().norm();
  if (gap > kAtTarget)
    ROS_WARN_STREAM("tf has the tool " << gap << " m (" << T_tool_seen->translation().transpose()
                                       << " in its axes) from where the joints and the arm's "
                                          "description have it; motions are planned so that tf "
                                          "arrives");
  return toolGapProblem(*T_tool_seen, commands_->toolGapLimits(), commands_->descriptionSource());
}

}  // namespace smore
