// SPDX-License-Identifier: BSD-3-Clause
// Stands between the retrieval and the robot: passes commands on while nothing is wrong.
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>

#include "smore/contact/motion_guard.h"
#include "smore/kinematics/joint_commands.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"

namespace smore {
namespace {

constexpr double kChecksPerSilence = 10.0;  // so a silence is seen at most a tenth late

MotionGuardParameters readGuardParameters(ParameterReader* reader) {
  constexpr double kMost = 1000.0;
  MotionGuardParameters parameters;
  reader->number("max_force", &parameters.max_force, {1.0, kMost});
  reader->number("max_torque", &parameters.max_torque, {0.1, kMost});
  reader->number("max_silence", &parameters.max_silence, {0.005, 10.0});
  reader->number("max_joint_speed", &parameters.max_joint_speed, {0.01, 10.0});
  reader->number("start_tolerance", &parameters.start_tolerance, {0.001, 1.0});
  reader->number("force_margin", &parameters.force_margin, {0.0, kMost});
  reader->number("torque_margin", &parameters.torque_margin, {0.0, kMost});
  return parameters;
}

/// Wall time that no setting of the clock moves [s]: a driver's silence is told by it, not by
/// stamps.
double now() { return ros::SteadyTime::now().toSec(); }

/// Everything happens in one thread, between two checks for silence.
class GuardNode {
 public:
  GuardNode(const MotionGuardParameters& parameters, std::vector<std::string> joint_names)
      : guard_(parameters, std::move(joint_names)),
        period_(parameters.max_silence / kChecksPerSilence) {
    node_.setCallbackQueue(&queue_);
    private_node_.setCallbackQueue(&queue_);
    constexpr bool kLatched = true;
    guarded_ = node_.advertise<trajectory_msgs::JointTrajectory>(names::kGuardedCommand,
                                                                 names::kLatestQueue);
    fault_ =
        private_node_.advertise<std_msgs::String>(names::kFault, names::kLatestQueue, kLatched);
    publishFault();
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    wrench_ =
        node_.subscribe(names::kWrench, names::kStreamQueue, &GuardNode::onWrench, this, hints);
    joints_ = node_.subscribe(names::kJointStates, names::kStreamQueue, &GuardNode::onJoints, this,
                              hints);
    command_ =
        node_.subscribe(names::kCommand, names::kLatestQueue, &GuardNode::onCommand, this, hints);
    stop_ = private_node_.advertiseService(names::kStop, &GuardNode::onStop, this);
    clear_ = private_node_.advertiseService(names::kClear, &GuardNode::onClear, this);
  }

  void run() {
    while (ros::ok()) {
      queue_.callAvailable(period_);
      guard_.check(now());
      reactToFault();
    }
  }

 private:
  void onWrench(const geometry_msgs::WrenchStamped& message) {
    guard_.onWrench(now(), message.header.stamp.toSec(), fromMessage(message.wrench));
    reactToFault();
  }

  void onJoints(const sensor_msgs::JointState& message) {
    guard_.onJoints(
        now(), {message.header.stamp.toSec(), message.name, message.position, message.velocity});
    reactToFault();
  }

  void onCommand(const trajectory_msgs::JointTrajectory& message) {
    const bool allowed = guard_.allows(now(), fromMessage(message));
    reactToFault();
    if (allowed) {
      guarded_.publish(message);
    } else {
      ROS_ERROR_STREAM("command refused: " << guard_.fault() << "; call '" << clear_.getService()
                                           << "' when the cause is gone");
    }
  }

  bool onStop(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    guard_.stop("stopped by the user");
    reactToFault();
    response.success = true;
    response.message = guard_.fault();
    return true;
  }

  bool onClear(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    guard_.clear(now());
    reactToFault();
    response.success = guard_.fault().empty();
    response.message = response.success ? "cleared" : guard_.fault();
    return true;
  }

  /// Stops the robot at a new fault, and tells of what has changed.
  void reactToFault() {
    if (guard_.fault() == published_) return;
    if (!guard_.fault().empty()) {
      guarded_.publish(trajectory_msgs::JointTrajectory());
      ROS_ERROR_STREAM("stopped: " << guard_.fault());
    }
    publishFault();
  }

  void publishFault() {
    published_ = guard_.fault();
    std_msgs::String message;
    message.data = published_;
    fault_.publish(message);
  }

  MotionGuard guard_;
  ros::WallDuration period_;  ///< between two checks for silence
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::NodeHandle private_node_{"~"};
  ros::Publisher guarded_, fault_;
  ros::Subscriber wrench_, joints_, command_;
  ros::ServiceServer stop_, clear_;
  std::string published_;
};

void runGuard() {
  ParameterReader reader(privateParameters(), ros::this_node::getName());
  const MotionGuardParameters parameters = readGuardParameters(&reader);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  requireScenario(&reader);
  reader.finish();
  GuardNode(parameters, makeJointCommands(*scenario)->jointNames()).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) { return smore::runNode(argc, argv, "guard", smore::runGuard); }
