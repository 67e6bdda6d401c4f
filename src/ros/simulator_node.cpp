// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <memory>

#include "simulated_driver.h"
#include "smore/contact/contact_reflex.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/throttle.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {
namespace {

// Half a period of the 500 Hz sensor: stamps are compared to this.
constexpr double kHalfSample = 0.001;

struct SimulatorParameters {
  FrameNames frames;
  int seed = 1;
  double sensor_cutoff = 0.0;          ///< of the sensor's low-pass [Hz]; 0: none
  double real_time_factor = 0.0;       ///< while moving; 0: as fast as the listener follows
  double rest_real_time_factor = 1.0;  ///< while at rest
  int lag_samples = 2;                 ///< samples that may run ahead of the listener
  double listener_timeout = 1.0;       ///< wall time to wait for it [s]
  double clock_period = 0.01;          ///< simulated time between clock messages [s]
  bool reflexes =
      true;  ///< stops at a new contact and when its commander is gone; else a guard does
};

SimulatorParameters readParameters(ParameterReader* reader) {
  SimulatorParameters parameters;
  parameters.frames = readFrameNames(reader);
  reader->integer("seed", &parameters.seed, 0, std::numeric_limits<int>::max());
  reader->number("sensor_cutoff", &parameters.sensor_cutoff, {0.0, 1000.0});
  reader->number("real_time_factor", &parameters.real_time_factor, {0.0, 1000.0});
  reader->number("rest_real_time_factor", &parameters.rest_real_time_factor, {0.01, 1000.0});
  reader->integer("lag_samples", &parameters.lag_samples, 0, 100);
  reader->number("listener_timeout", &parameters.listener_timeout, {0.01, 60.0});
  reader->number("clock_period", &parameters.clock_period, {0.002, 1.0});
  reader->boolean("reflexes", &parameters.reflexes);
  return parameters;
}

/// Steps the simulated robot in lock-step with the listener, in one thread: commands, observations
/// and services are handled between two samples.
class SimulatorNode {
 public:
  SimulatorNode(const SimulatorParameters& parameters, const Scenario& scenario)
      : parameters_(parameters),
        robot_(makeSimulatedRobot(
            scenario, parameters.seed,
            parameters.sensor_cutoff > 0.0 ? parameters.sensor_cutoff : kNoLowPass)),
        driver_(makeSimulatedDriver(scenario, parameters.frames)),
        start_(scenario.start) {
    node_.setCallbackQueue(&queue_);
    ros::NodeHandle private_node("~");
    private_node.setCallbackQueue(&queue_);
    advertise(&private_node, scenario);
  }

  void run() {
    while (ros::ok()) {
      queue_.callAvailable();
      waitForListener();
      waitForClock();
      step();
    }
  }

 private:
  void advertise(ros::NodeHandle* private_node, const Scenario& scenario) {
    wrench_ = node_.advertise<geometry_msgs::WrenchStamped>(names::kWrench, names::kStreamQueue);
    joints_ = node_.advertise<sensor_msgs::JointState>(
        names::kJointStates, names::kStreamQueue, ros::SubscriberStatusCallback(),
        [this](const auto& listener) { onJointListenerGone(listener.getSubscriberName()); });
    tf_ = node_.advertise<tf2_msgs::TFMessage>(names::kTf, names::kStreamQueue);
    tf_static_ = node_.advertise<tf2_msgs::TFMessage>(names::kTfStatic, names::kLatestQueue, true);
    clock_ = node_.advertise<rosgraph_msgs::Clock>(names::kClock, names::kStreamQueue);
    scene_ =
        node_.advertise<visualization_msgs::MarkerArray>(names::kScene, names::kLatestQueue, true);
    publishScene(scenario);
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    command_ = node_.subscribe(names::kCommand, names::kLatestQueue, &SimulatorNode::onCommand,
                               this, hints);
    contact_ = node_.subscribe(names::kContact, names::kStreamQueue, &SimulatorNode::onContact,
                               this, hints);
    reset_ = private_node->advertiseService(names::kResetSimulator, &SimulatorNode::onReset, this);
  }

  void publishScene(const Scenario& scenario) {
    scene_.publish(driver_->markersIn(scenario, parameters_.frames));
    tf2_msgs::TFMessage fixed;
    fixed.transforms = driver_->fixedTransforms();
    tf_static_.publish(fixed);
  }

  void onCommand(const ros::MessageEvent<trajectory_msgs::JointTrajectory const>& event) {
    const trajectory_msgs::JointTrajectory& message = *event.getMessage();
    commander_ = event.getPublisherName();
    reflex_.onMotion();
    if (message.points.empty()) return robot_->stop();
    try {
      const std::optional<Failure> refused = robot_->followJoints(fromMessage(message));
      if (refused) ROS_ERROR_STREAM("command refused: " << refused->reason);
    } catch (const InputError& error) {
      ROS_ERROR_STREAM("command refused: " << error.what());
    }
  }

  /// Who commands a motion listens to where it leads; with its connection the motion ends.
  void onJointListenerGone(const std::string& name) {
    if (!parameters_.reflexes || name != commander_ || !robot_->moving()) return;
    robot_->stop();
    ROS_ERROR_STREAM("stopped: '" << name << "', who commanded the motion, is gone");
  }

  void onContact(const smore_msgs::ContactObservation& message) {
    acknowledged_ = std::max(acknowledged_, message.header.stamp.toSec());
    if (!lock_step_) ROS_INFO("the listener follows: lock-step");
    lock_step_ = true;
    const bool touching = message.state == smore_msgs::ContactObservation::CONTACT;
    const bool ends = reflex_.onObservation(touching, message.contact_id);
    if (ends && parameters_.reflexes && robot_->moving()) robot_->stop();
  }

  bool onReset(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    robot_->place(start_);
    response.success = true;
    response.message = "the object is at the start";
    return true;
  }

  bool listenerIsBehind() const {
    const double allowed = parameters_.lag_samples * 2.0 * kHalfSample + kHalfSample;
    return published_ - acknowledged_ > allowed;
  }

  void waitForListener() {
    if (!lock_step_) return warnOfSilence();
    const ros::WallTime deadline =
        ros::WallTime::now() + ros::WallDuration(parameters_.listener_timeout);
    while (ros::ok() && lock_step_ && listenerIsBehind()) {
      const ros::WallDuration left = deadline - ros::WallTime::now();
      if (left.toSec() <= 0.0) {
        if (parameters_.reflexes && robot_->moving()) {
          ROS_ERROR("stopped: the listener does not answer");
          robot_->stop();
        }
        lock_step_ = false;
        begin_ = ros::WallTime::now();
        return;
      }
      queue_.callAvailable(left);
    }
  }

  void warnOfSilence() {
    if ((ros::WallTime::now() - begin_).toSec() < kStartUp || !warning_.isDue()) return;
    ROS_WARN_STREAM("no observations on '"
                    << node_.resolveName(names::kContact)
                    << "': going on at real time without contact reflex; is the "
                       "force_torque node running?");
  }

  /// Simulated seconds per second of wall time; 0 for no limit.
  double pace() const {
    const double limit =
        robot_->moving() ? parameters_.real_time_factor : parameters_.rest_real_time_factor;
    if (lock_step_) return limit;
    return limit > 0.0 ? std::min(limit, 1.0) : 1.0;
  }

  void waitForClock() {
    const ros::WallTime now = ros::WallTime::now();
    if (next_step_ < now - ros::WallDuration(kCatchUp)) next_step_ = now;
    while (ros::ok() && pace() > 0.0) {
      const ros::WallDuration left = next_step_ - ros::WallTime::now();
      if (left.toSec() <= 0.0) break;
      queue_.callAvailable(left);
    }
    if (pace() > 0.0) next_step_ += ros::WallDuration(2.0 * kHalfSample / pace());
  }

  void step() {
    const double time = robot_->advance().time;
    ros::Time stamp;
    stamp.fromSec(time);
    publishTransforms(stamp);
    publishClock(stamp);
    publishJoints(stamp);
    reportFault();
    geometry_msgs::WrenchStamped wrench;
    wrench.header.stamp = stamp;
    wrench.header.frame_id = driver_->sensorFrame();
    wrench.wrench = toMessage(robot_->reading().wrench);
    wrench_.publish(wrench);
    published_ = stamp.toSec();
  }

  void publishTransforms(const ros::Time& stamp) {
    tf2_msgs::TFMessage message;
    message.transforms = driver_->transformsAt(*robot_, stamp);
    tf_.publish(message);
  }

  void reportFault() {
    const std::optional<Failure> fault = robot_->fault();
    if (fault && !faulty_) ROS_ERROR_STREAM("the robot has stopped by itself: " << fault->reason);
    faulty_ = fault.has_value();
  }

  void publishClock(const ros::Time& stamp) {
    if ((stamp - last_clock_).toSec() < parameters_.clock_period - kHalfSample) return;
    last_clock_ = stamp;
    rosgraph_msgs::Clock message;
    message.clock = stamp;
    clock_.publish(message);
  }

  void publishJoints(const ros::Time& stamp) {
    if (joints_.getNumSubscribers() == 0) return;
    sensor_msgs::JointState message;
    message.header.stamp = stamp;
    message.name = robot_->jointNames();
    message.position = robot_->jointPositions();
    message.velocity = robot_->jointVelocities();
    if (const auto gripper = robot_->gripper()) {
      message.name.push_back(gripper->joint);
      message.position.push_back(gripper->position);
      message.velocity.push_back(0.0);
    }
    joints_.publish(message);
  }

  static constexpr double kWarningPeriod = 5.0;  // [s]
  static constexpr double kStartUp = 5.0;  // [s]; nodes that start together find one another in it
  static constexpr double kCatchUp = 0.1;  // [s]; what is lost beyond is not made good

  SimulatorParameters parameters_;
  std::unique_ptr<SimulatedRobot> robot_;
  std::unique_ptr<SimulatedDriver> driver_;
  Pose start_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Publisher wrench_, joints_, tf_, tf_static_, clock_, scene_;
  ros::Subscriber command_, contact_;
  ros::ServiceServer reset_;
  double published_ = 0.0;     ///< stamp of the last sample [s]
  double acknowledged_ = 0.0;  ///< newest stamp among the listener's observations [s]
  bool lock_step_ = false;     ///< from the listener's first observation on
  ros::WallTime begin_ = ros::WallTime::now();
  ContactReflex reflex_;
  std::string commander_;  ///< name of the node that sent the newest command
  Throttle warning_{kWarningPeriod};
  ros::WallTime next_step_;
  ros::Time last_clock_;
  bool faulty_ = false;
};

void runSimulator() {
  ParameterReader reader(privateParameters(), ros::this_node::getName());
  const SimulatorParameters parameters = readParameters(&reader);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  requireScenario(&reader);
  reader.finish();
  SimulatorNode(parameters, perturbScenario(*scenario, parameters.seed)).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) {
  return smore::runNode(argc, argv, "simulator", smore::runSimulator);
}
