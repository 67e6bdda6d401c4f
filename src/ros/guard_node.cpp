// SPDX-License-Identifier: BSD-3-Clause
// Stands between the retrieval and the robot: hands it motions piece by piece while nothing is
// wrong, and stops it.
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "guard_limits.h"
#include "guard_parameters.h"
#include "smore/contact/contact_reflex.h"
#include "smore/contact/hold_up_watch.h"
#include "smore/contact/motion_guard.h"
#include "smore/kinematics/joint_commands.h"
#include "smore/kinematics/motion_stream.h"
#include "smore/ros/controller_watch.h"
#include "smore/ros/guard_status.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/safety_mode.h"
#include "smore/ros/shutdown_request.h"
#include "smore/ros/speed_listener.h"
#include "smore/ros/throttle.h"

namespace smore {
namespace {

constexpr double kChecksPerLateness = 10.0;  // so it is seen a tenth late, unless held up
constexpr double kPeriodsHeldUp = 4.0;       // in one turn, which takes one at most
constexpr double kAtRest = 1e-3;             // joints that stand are slower than this [rad/s]
constexpr double kWarningPeriod = 5.0;       // [s] between warnings of one kind
// A robot that was told to stop when the node ends stands after this [s of wall time], or it does
// not obey.
constexpr double kLastStop = 0.3;

/// Wall time that no setting of the clock moves [s]: a driver's silence is told by it, not by
/// stamps.
double now() { return ros::SteadyTime::now().toSec(); }

/// When what bears a stamp was new, by that clock [s]. A ros::Duration holds no far future.
double measuredAt(const ros::Time& stamp) {
  return now() - std::max(0.0, ros::Time::now().toSec() - stamp.toSec());
}

/// Everything happens in one thread, between two checks for silence.
class GuardNode {
 public:
  GuardNode(const GuardParameters& parameters, std::vector<std::string> joint_names)
      : guard_(parameters.guard, joint_names),
        stream_(parameters.horizon),
        deceleration_(parameters.horizon.deceleration),
        joint_names_(std::move(joint_names)),
        limits_(parameters.guard.limits),
        period_(parameters.guard.max_lateness / kChecksPerLateness),
        turns_(now(), kPeriodsHeldUp * period_.toSec()) {
    node_.setCallbackQueue(&queue_);
    private_node_.setCallbackQueue(&queue_);
    constexpr bool kLatched = true;
    guarded_ = node_.advertise<trajectory_msgs::JointTrajectory>(names::kGuardedCommand,
                                                                 names::kLatestQueue);
    controller_.emplace(&queue_, guarded_);
    fault_ =
        private_node_.advertise<std_msgs::String>(names::kFault, names::kLatestQueue, kLatched);
    publishFault();
    subscribe();
    stop_ = private_node_.advertiseService(names::kStop, &GuardNode::onStop, this);
    clear_ = private_node_.advertiseService(names::kClear, &GuardNode::onClear, this);
    statuses_.add("motion", [this](Status* status) { compose(report(), status); });
  }

  void run() {
    while (!shutdown_.pending()) {
      turns_.onTurn(now());
      queue_.callAvailable(period_);
      beginCommanded();
      if (stream_.active() && turns_.upToDate(now())) {
        guard_.checkMotion(turns_.heard(), stream_.expected());
        checkController();
        waitWhileLate();
      }
      guard_.check(turns_.heard());
      reactToFault();
      statuses_.publishIfDue();
    }
    endAtRest();
  }

 private:
  void subscribe() {
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    wrench_ =
        node_.subscribe(names::kWrench, names::kStreamQueue, &GuardNode::onWrench, this, hints);
    joints_ = node_.subscribe(names::kJointStates, names::kStreamQueue, &GuardNode::onJoints, this,
                              hints);
    contact_ =
        node_.subscribe(names::kContact, names::kStreamQueue, &GuardNode::onContact, this, hints);
    command_ =
        node_.subscribe(names::kCommand, names::kLatestQueue, &GuardNode::onCommand, this, hints);
    sign_of_life_ = node_.subscribe(names::kSignOfLife, names::kLatestQueue,
                                    &GuardNode::onSignOfLife, this, hints);
    program_ = node_.subscribe(names::kProgramRunning, names::kLatestQueue, &GuardNode::onProgram,
                               this, hints);
    safety_ =
        node_.subscribe(names::kSafetyMode, names::kLatestQueue, &GuardNode::onSafety, this, hints);
  }

  void onWrench(const geometry_msgs::WrenchStamped& message) {
    guard_.limitTo(limits_.now());
    const ros::Time& stamp = message.header.stamp;
    guard_.onWrench(measuredAt(stamp), stamp.toSec(), fromMessage(message.wrench));
    reactToFault();
  }

  void onJoints(const sensor_msgs::JointState& message) {
    guard_.limitTo(limits_.now());
    const ros::Time& stamp = message.header.stamp;
    guard_.onJoints(measuredAt(stamp),
                    {stamp.toSec(), message.name, message.position, message.velocity});
    reactToFault();
    const auto joints = guard_.joints(now());
    if (!stream_.active() || !joints || !turns_.upToDate(now())) return;
    // What else has come may wait behind this message still, and seem late: the next horizon makes
    // up for one that is withheld.
    const auto horizon = stream_.advance(joints->time, braked_ ? 0.0 : speed_.scaling());
    if (horizon && guard_.lateness(turns_.heard()).empty()) guarded_.publish(toMessage(*horizon));
  }

  /// Brakes a motion that must wait, which then stays as far as it has come. Where the joints are
  /// late it cannot be braked yet, and comes as far as the robot.
  void waitWhileLate() {
    const std::string lateness = guard_.lateness(turns_.heard());
    if (!lateness.empty() && !braked_ && late_warning_.isDue()) {
      ROS_WARN_STREAM("the motion waits: " << lateness);
    }
    braked_ = !lateness.empty() && (braked_ || brakeNow());
  }

  void onContact(const smore_msgs::ContactObservation& message) {
    const bool unsure = message.state == smore_msgs::ContactObservation::UNSURE;
    guard_.onContact(measuredAt(message.header.stamp), message.header.stamp.toSec(), !unsure);
    const bool touching = message.state == smore_msgs::ContactObservation::CONTACT;
    if (reflex_.onObservation(touching, message.contact_id)) halt();
  }

  void onSignOfLife(const std_msgs::Empty& /*message*/) { guard_.onSignOfLife(now()); }

  void onProgram(const std_msgs::Bool& message) { guard_.onProgram(message.data != 0); }

  void onSafety(const topic_tools::ShapeShifter& message) {
    const auto mode = safetyModeOf(message);
    if (!mode) return guard_.stop("'" + safety_.getTopic() + "' brings no safety mode");
    guard_.onSafetyStop(safetyStop(*mode));
  }

  void onCommand(const trajectory_msgs::JointTrajectory& message) {
    if (message.points.empty()) return halt();
    reflex_.onMotion();  // by what is known now: what touches from now on ends it
    commanded_ = message;
  }

  /// A motion begins when what came before its command is known.
  void beginCommanded() {
    if (!commanded_ || !turns_.upToDate(now())) return;
    const auto message = std::exchange(commanded_, std::nullopt);
    guard_.limitTo(limits_.now());
    checkController();
    const auto motion = guard_.admit(turns_.heard(), fromMessage(*message));
    reactToFault();
    if (!motion) {
      ROS_ERROR_STREAM("command refused: " << guard_.fault() << "; call '" << clear_.getService()
                                           << "' when the cause is gone");
      return;
    }
    stream_.begin(*motion);
    braked_ = false;
  }

  void checkController() {
    const std::string problem = controller_->problem(turns_.heard());
    if (!problem.empty()) guard_.stop(problem);
  }

  void halt() {
    commanded_.reset();
    brakeNow();
    stream_.end();
  }

  /// Brakes from where the joints are now. Where that is not known, a motion ends with the last
  /// horizon that the robot got; without one the robot is told to stop as it can. Whether it
  /// brakes.
  bool brakeNow() {
    const auto joints = guard_.jointsToBrakeFrom(now());
    if (joints) {
      guarded_.publish(toMessage(brake(joint_names_, *joints, deceleration_, speed_.scaling())));
    } else if (!stream_.active()) {
      guarded_.publish(trajectory_msgs::JointTrajectory());
    }
    return joints.has_value();
  }

  void endAtRest() {
    halt();
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kLastStop);
    while (!stands() && ros::ok() && ros::WallTime::now() < deadline) {
      queue_.callAvailable(period_);
    }
  }

  bool stands() const {
    const auto joints = guard_.joints(now());
    return joints && std::all_of(joints->velocities.begin(), joints->velocities.end(),
                                 [](double velocity) { return std::abs(velocity) < kAtRest; });
  }

  bool onStop(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    guard_.stop("stopped by the user");
    reactToFault();
    response.success = true;
    response.message = guard_.fault();
    return true;
  }

  bool onClear(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    guard_.clear(turns_.heard());
    reactToFault();
    response.success = guard_.fault().empty();
    response.message = response.success ? "cleared" : guard_.fault();
    return true;
  }

  GuardReport report() const {
    const MotionLimits& limits = guard_.limits();
    return {guard_.fault(), guard_.lateness(turns_.heard()), stream_.active(), limits.max_force,
            limits.max_torque};
  }

  /// Stops the robot at a new fault, and tells of what has changed.
  void reactToFault() {
    if (guard_.fault() == published_) return;
    if (!guard_.fault().empty()) {
      halt();
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

  ShutdownRequest shutdown_;
  MotionGuard guard_;
  ContactReflex reflex_;
  MotionStream stream_;
  double deceleration_;  ///< of a brake [rad/s^2]
  std::vector<std::string> joint_names_;
  GuardLimits limits_;
  ros::WallDuration period_;  ///< between two checks for silence
  HoldUpWatch turns_;         ///< silence is not that this node was held up
  std::optional<trajectory_msgs::JointTrajectory> commanded_;  ///< and has not begun
  bool braked_ = false;  ///< whether the motion waits, since what is known is late
  Throttle late_warning_{kWarningPeriod};
  ros::CallbackQueue queue_;
  SpeedListener speed_{&queue_};
  ros::NodeHandle node_;
  ros::NodeHandle private_node_{"~"};
  ros::Publisher guarded_, fault_;
  ros::Subscriber wrench_, joints_, contact_, command_, sign_of_life_, program_, safety_;
  ros::ServiceServer stop_, clear_;
  std::optional<ControllerWatch> controller_;
  std::string published_;
  StatusPublisher statuses_;
};

void runGuard() {
  ParameterReader reader(privateParameters(), ros::this_node::getName());
  GuardParameters parameters = readGuardParameters(&reader);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  requireScenario(&reader);
  reader.finish();
  fitToSensor(*scenario, &parameters);
  GuardNode(parameters, makeJointCommands(*scenario)->jointNames()).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) { return smore::runNode(argc, argv, "guard", smore::runGuard); }
