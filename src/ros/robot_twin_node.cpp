// SPDX-License-Identifier: BSD-3-Clause
// A simulated UR5e behind what its driver for ROS 1 does with it: its names, its controller, its
// delays and its faults.
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <std_msgs/UInt8.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "robot_twin_parameters.h"
#include "simulated_driver.h"
#include "smore/common/delay_line.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/simulation/calibrated_arm.h"
#include "smore/simulation/driver_wrench.h"
#include "smore/simulation/simulated_robot.h"
#include "smore/simulation/trajectory_controller.h"

namespace smore {
namespace {

constexpr double kPeriod = 0.002;    // 500 Hz
constexpr std::uint8_t kNormal = 1;  // safety modes of ur_dashboard_msgs/SafetyMode
constexpr std::uint8_t kProtectiveStop = 3;
constexpr std::uint8_t kRobotEmergencyStop = 7;
constexpr double kCatchUp = 0.1;  // [s]; what is lost beyond is not made good

/// What the driver publishes for one sample.
struct DriverSample {
  sensor_msgs::JointState joints;
  geometry_msgs::WrenchStamped wrench;
  tf2_msgs::TFMessage poses;  ///< empty while the network is cut
};

/// Robot, driver and connection in one thread, at 500 Hz of the clock on the wall.
class RobotTwin {
 public:
  RobotTwin(const TwinParameters& parameters, const Scenario& scenario, const UrdfModel& arm)
      : parameters_(parameters),
        robot_(makeSimulatedArm(
            scenario, arm, parameters.seed,
            parameters.sensor_cutoff > 0.0 ? parameters.sensor_cutoff : kNoLowPass)),
        driver_(makeArmDriver(scenario, parameters.frames, arm, parameters.pendant.tcp)),
        wrench_of_driver_(parameters.pendant),
        controller_(robot_->jointNames(), robot_->jointPositions(), parameters.stop_duration),
        random_(parameters.seed),
        slider_(parameters.slider),
        latency_(parameters.latency_min, parameters.latency_max) {
    node_.setCallbackQueue(&queue_);
    private_node_.setCallbackQueue(&queue_);
    advertise();
    publishScene(scenario);
    publishSafetyMode(kNormal);
    publishRunning();
  }

  void run() {
    ros::SteadyTime next = ros::SteadyTime::now();
    while (ros::ok()) {
      const ros::SteadyTime now = ros::SteadyTime::now();
      if (next < now - ros::WallDuration(kCatchUp)) next = now;
      queue_.callAvailable(std::max(next - now, ros::WallDuration()));
      if (ros::SteadyTime::now() < next) continue;
      next += ros::WallDuration(kPeriod);
      cycle(ros::SteadyTime::now().toSec());
    }
  }

 private:
  /// The driver's names are global.
  void advertise() {
    joints_ = node_.advertise<sensor_msgs::JointState>("/joint_states", names::kStreamQueue);
    wrench_ = node_.advertise<geometry_msgs::WrenchStamped>("/wrench", names::kStreamQueue);
    tf_ = node_.advertise<tf2_msgs::TFMessage>(names::kTf, names::kStreamQueue);
    scene_ = node_.advertise<visualization_msgs::MarkerArray>(names::kScene, 1, true);
    tf_static_ = node_.advertise<tf2_msgs::TFMessage>(names::kTfStatic, 1, true);
    scaling_ = node_.advertise<std_msgs::Float64>("/speed_scaling_factor", 1);
    running_ =
        node_.advertise<std_msgs::Bool>("/ur_hardware_interface/robot_program_running", 1, true);
    state_ = node_.advertise<sensor_msgs::JointState>("/scaled_pos_joint_traj_controller/state", 1);
    safety_mode_ = node_.advertise<std_msgs::UInt8>("/ur_hardware_interface/safety_mode", 1, true);
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    command_ = node_.subscribe("/scaled_pos_joint_traj_controller/command", names::kStreamQueue,
                               &RobotTwin::onCommand, this, hints);
    slider_topic_ = private_node_.subscribe("slider", 1, &RobotTwin::onSlider, this);
    serve<std_srvs::Trigger>(&node_, "/ur_hardware_interface/zero_ftsensor", [this](bool) {
      // The driver answers when it has written to the robot; the zeroing follows.
      wrench_of_driver_.askForZero(now() + parameters_.zero_delay);
    });
    advertiseFaults();
  }

  void advertiseFaults() {
    using std_srvs::SetBool;
    using std_srvs::Trigger;
    serve<Trigger>(&private_node_, "protective_stop", [this](bool) { halt(kProtectiveStop); });
    serve<Trigger>(&private_node_, "emergency_stop", [this](bool) { halt(kRobotEmergencyStop); });
    serve<Trigger>(&private_node_, "end_program", [this](bool) { halt(kNormal); });
    serve<Trigger>(&private_node_, "play", [this](bool) { play(); });
    serve<SetBool>(&private_node_, "run_controller", [this](bool run) { runController(run); });
    serve<SetBool>(&private_node_, "cut_network", [this](bool cut) { cutNetwork(cut); });
  }

  static bool dataOf(const std_srvs::Trigger::Request& /*request*/) { return true; }
  static bool dataOf(const std_srvs::SetBool::Request& request) { return request.data != 0; }

  /// A service that does `action` and answers that it is done.
  template <typename Service>
  void serve(ros::NodeHandle* node, const std::string& name,
             const std::function<void(bool)>& action) {
    using Callback = boost::function<bool(typename Service::Request&, typename Service::Response&)>;
    services_.push_back(
        node->advertiseService(name, Callback([action](auto& request, auto& response) {
                                 action(dataOf(request));
                                 response.success = static_cast<unsigned char>(true);
                                 return true;
                               })));
  }

  void publishScene(const Scenario& scenario) {
    scene_.publish(driver_->markersIn(scenario, parameters_.frames));
    tf2_msgs::TFMessage fixed;
    fixed.transforms = driver_->controllerTransforms();
    tf_static_.publish(fixed);
  }

  void onCommand(const trajectory_msgs::JointTrajectory& message) {
    if (!cut_off_) commands_.push(now() + latency_(random_), fromMessage(message));
  }

  void onSlider(const std_msgs::Float64& message) {
    if (std::isfinite(message.data)) slider_ = std::clamp(message.data, 0.0, 1.0);
  }

  void halt(std::uint8_t safety_mode) {
    publishSafetyMode(safety_mode);
    endProgram("somebody asked for it");
  }

  /// A UR zeroes its sensor whenever its program starts (developers in the driver's issue 512).
  void play() {
    wrench_of_driver_.askForZero(now() + parameters_.zero_delay);
    controller_.start(robot_->jointPositions());
    publishSafetyMode(kNormal);
    publishRunning();
  }

  /// As the controller manager that starts or stops the controller alone.
  void runController(bool run) {
    if (run) return controller_.start(robot_->jointPositions());
    controller_.stop();
    robot_->stop();
  }

  /// The robot's program ends without its driver; joint states and wrenches freeze under fresh
  /// stamps.
  void cutNetwork(bool cut) {
    cut_off_ = cut;
    if (cut) runController(false);
  }

  void endProgram(const std::string& reason) {
    ROS_WARN_STREAM("the robot's program has ended: " << reason);
    runController(false);
    publishRunning();
  }

  /// On the wire as the driver's ur_dashboard_msgs/SafetyMode, which Debian lacks.
  void publishSafetyMode(std::uint8_t mode) {
    std_msgs::UInt8 message;
    message.data = mode;
    safety_mode_.publish(message);
  }

  void publishRunning() {
    std_msgs::Bool message;
    message.data = static_cast<unsigned char>(controller_.running());
    running_.publish(message);
  }

  void cycle(double now) {
    while (const auto command = commands_.pop(now)) controller_.command(*command);
    moveRobot();
    samples_.push(now + latency_(random_), sample(now));
    while (const auto arrived = samples_.pop(now)) publish(*arrived);
  }

  /// The controller tells the robot each cycle where to be at its end, and how fast: a point beyond
  /// it, since a robot rests at the last.
  void moveRobot() {
    if (controller_.running()) {
      controller_.advance(kPeriod, slider_);
      JointTrajectoryPoint now{kPeriod, controller_.positions(), controller_.velocities()};
      for (double& velocity : now.velocities) velocity *= slider_;
      JointTrajectoryPoint beyond = now;
      beyond.time += kPeriod;
      for (size_t i = 0; i < beyond.positions.size(); ++i) {
        beyond.positions[i] += kPeriod * now.velocities[i];
      }
      robot_->followJoints({robot_->jointNames(), {now, beyond}});
    }
    robot_->advance();
    const std::optional<Failure> fault = robot_->fault();
    if (fault && controller_.running()) endProgram(fault->reason);
  }

  DriverSample sample(double now) {
    ros::Time stamp = ros::Time::now();
    std::normal_distribution<double> jitter(0.0, 1.0);
    stamp += ros::Duration(parameters_.stamp_jitter * jitter(random_));
    if (!cut_off_) {
      last_.joints.name = robot_->jointNames();
      last_.joints.position = robot_->jointPositions();
      last_.joints.velocity = robot_->jointVelocities();
      const Pose T_world_flange = robot_->pose() * robot_->T_sensor_object().inverse();
      last_.wrench.wrench =
          toMessage(wrench_of_driver_.at(now, robot_->reading().wrench, T_world_flange));
      last_.wrench.header.frame_id = driver_->sensorFrame();
    }
    last_.poses.transforms.clear();
    if (!cut_off_) last_.poses.transforms = driver_->transformsAt(*robot_, stamp);
    last_.joints.header.stamp = last_.wrench.header.stamp = stamp;
    return last_;
  }

  void publish(const DriverSample& sample) {
    if (!sample.poses.transforms.empty()) tf_.publish(sample.poses);
    joints_.publish(sample.joints);
    if (controller_.running() || cut_off_) publishState();  // which knows of no cut
    wrench_.publish(sample.wrench);
    std_msgs::Float64 scaling;
    scaling.data = slider_;
    scaling_.publish(scaling);
  }

  /// The driver's type is control_msgs', which Debian lacks; that it comes is what counts here.
  void publishState() {
    sensor_msgs::JointState state;
    state.header.stamp = ros::Time::now();
    state.name = robot_->jointNames();
    state.position = controller_.positions();
    state.velocity = controller_.velocities();
    state_.publish(state);
  }

  static double now() { return ros::SteadyTime::now().toSec(); }
  TwinParameters parameters_;
  std::unique_ptr<SimulatedRobot> robot_;
  std::unique_ptr<SimulatedDriver> driver_;
  DriverWrench wrench_of_driver_;
  TrajectoryController controller_;
  std::mt19937_64 random_;
  double slider_;  ///< share of full speed, 0 to 1
  std::uniform_real_distribution<double> latency_;
  DelayLine<JointTrajectory> commands_;
  DelayLine<DriverSample> samples_;
  DriverSample last_;
  bool cut_off_ = false;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_, private_node_{"~"};
  ros::Publisher joints_, wrench_, tf_, tf_static_, scene_, scaling_, running_, state_,
      safety_mode_;
  ros::Subscriber command_, slider_topic_;
  std::vector<ros::ServiceServer> services_;
};

void runTwin() {
  ParameterReader reader(privateParameters(), ros::this_node::getName());
  const TwinParameters parameters = readTwinParameters(&reader);
  const auto scenario = readScenarioParameter(&reader);
  requireScenario(&reader);
  reader.finish();
  requireArm(*scenario);
  const UrdfModel arm = calibratedArm(*scenario, parameters.calibration, parameters.seed);
  ros::param::set("/robot_description",
                  jointsDescription(parameters.described ? arm : armUrdf(*scenario)));
  RobotTwin(parameters, perturbScenario(*scenario, parameters.seed), arm).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) { return smore::runNode(argc, argv, "robot_twin", smore::runTwin); }
