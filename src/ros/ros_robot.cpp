// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/ros_robot.h"

#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Trigger.h>

#include <limits>
#include <utility>

#include "smore/common/retreat.h"
#include "smore/kinematics/tool_gap.h"
#include "smore/ros/interruptible_call.h"
#include "smore/ros/names.h"
#include "smore/ros/settle_deadline.h"

namespace smore {
namespace {

// The way before a touch on which its force's work is looked at [m + rad].
constexpr double kWayOfWork = 0.004;
// Each leaves a small share of what the one before left.
constexpr int kMostAims = 3;

}  // namespace

struct RosRobot::Motion {
  MotionProgress progress;
  ContactObservation last;
  int known_contacts = 0;
  std::string reason;                   ///< why it ended
  std::optional<MotionResult> refused;  ///< where it could not begin
  int aims = 0;                         ///< so often it has set out again, short of its target
};

RosRobot::RosRobot(const RosRobotParameters& parameters, std::unique_ptr<JointCommands> commands)
    : parameters_(parameters),
      commands_(std::move(commands)),
      joints_(&queue_, commands_->jointNames()),
      guard_(&queue_),
      speed_(&queue_) {
  node_.setCallbackQueue(&queue_);
  command_ =
      node_.advertise<trajectory_msgs::JointTrajectory>(names::kCommand, names::kLatestQueue);
  sign_of_life_ = node_.advertise<std_msgs::Empty>(names::kSignOfLife, names::kLatestQueue);
  const boost::function<void(const smore_msgs::ContactObservation&)> on_contact =
      [this](const smore_msgs::ContactObservation& message) {
        const Result<ContactObservation> observation = fromMessage(message);
        if (!observation) return;
        press_.observe(observation->time, observation->state);
        fault_place_.observe(
            {observation->time, observation->T_world_object, faulted(), press_.presses()});
        stream_.push(*observation);
      };
  contact_ = node_.subscribe<smore_msgs::ContactObservation>(
      names::kContact, names::kObservationQueue, on_contact, ros::VoidConstPtr(),
      ros::TransportHints().tcpNoDelay());
  const boost::function<void(const std_msgs::Bool&)> on_program =
      [this](const std_msgs::Bool& message) { onProgram(message.data != 0); };
  program_ =
      node_.subscribe<std_msgs::Bool>(names::kProgramRunning, names::kLatestQueue, on_program);
  if (!parameters_.reset_service.empty()) {
    reset_ = node_.serviceClient<std_srvs::Trigger>(parameters_.reset_service);
  }
  spinner_.start();
}

Pose RosRobot::pose() const {
  return stream_.latest().value_or(ContactObservation{}).T_world_object;
}

double RosRobot::stamp() const { return stream_.latest().value_or(ContactObservation{}).time; }

void RosRobot::onProgram(bool runs) {
  if (runs && !program_runs_) fault_place_.onProgramStart(press_.pressesFromTheWay());
  program_runs_ = runs;
}

void RosRobot::requestStop() {
  const std::lock_guard<std::mutex> lock(command_mutex_);
  stop_requested_ = true;
  halt();
}

void RosRobot::send(const JointTrajectory& trajectory) {
  const std::lock_guard<std::mutex> lock(command_mutex_);
  if (!stop_requested_) command_.publish(toMessage(trajectory));
}

MotionResult RosRobot::follow(const Path& path) {
  trail_.setOutFrom(pose());
  if (pressesAtRest()) return {MotionEnd::kContact, "", 0.0, false};
  press_.setOut();
  Motion motion = begin(path, Way::kNew);
  if (motion.refused) return *motion.refused;
  while (true) {
    switch (advance(&motion)) {
      case Step::kStalled:  // it may go on until it is late
        aimAgain(&motion);
        trail_.record(motion.last.T_world_object);
        break;
      case Step::kGoOn:
        trail_.record(motion.last.T_world_object);
        break;
      case Step::kArrived:
        halt();
        return end(motion, MotionEnd::kReached);
      case Step::kContact:
        return endInContact(&motion);
      case Step::kFault:
        return endStopped(motion);
    }
  }
}

MotionResult RosRobot::retreat(double distance) {
  trail_.setOutFrom(pose());  // it knows no way back from where somebody else has moved it
  const auto result = retreatInStretches({[&] { return trail_.wayBack(pose(), distance); },
                                          [this](const Path& back) { return goBack(back); },
                                          [this] { return waitUntilFree(); }});
  if (result) return *result;
  halt();
  if (stop_requested_) return {MotionEnd::kStopped, "stopped by the user", 0.0};
  return {MotionEnd::kFault, kStillInContact, 0.0};
}

MotionResult RosRobot::goBack(const Path& back) {
  press_.setOut();
  Motion motion = begin(back, Way::kBack);
  if (motion.refused) return *motion.refused;
  while (true) {
    const Step step = advance(&motion);
    trail_.unwind(motion.last.T_world_object);
    if (step == Step::kFault) return endStopped(motion);
    if (step == Step::kArrived || step == Step::kStalled) {
      halt();
      return end(motion, MotionEnd::kReached);
    }
    motion.known_contacts = motion.last.contact_id;
  }
}

MotionResult RosRobot::reset(const Pose& start) {
  if (parameters_.reset_service.empty()) {
    return retreat(std::numeric_limits<double>::infinity());
  }
  MotionResult result;
  std_srvs::Trigger call;
  if (stop_requested_) return {MotionEnd::kStopped, "stopped by the user", 0.0};
  const bool answered =
      callInterruptibly(reset_, &call, [this] { return stopRequested() || !ros::ok(); });
  if (!answered || !call.response.success) {
    result.reason = "the service '" + reset_.getService() + "' failed: " + call.response.message;
  } else if (!waitUntilAt(start)) {
    result.reason = "the robot did not come to the start";
  } else if (!waitUntilFree()) {
    result.reason = "the sensor feels a force at the start pose";
  }
  trail_.clear();
  if (!result.reason.empty()) result.end = MotionEnd::kFault;
  if (stop_requested_) result = {MotionEnd::kStopped, "stopped by the user", 0.0};
  return result;
}

std::optional<ContactObservation> RosRobot::nextObservation() {
  const ros::WallTime deadline =
      ros::WallTime::now() + ros::WallDuration(parameters_.silence_timeout);
  while (ros::ok() && !stop_requested_ && ros::WallTime::now() < deadline) {
    if (auto observation = stream_.next(kLookPeriod)) return observation;
  }
  return std::nullopt;
}

std::string RosRobot::guardFault() const {
  const std::string fault = guard_.fault();
  if (!fault.empty()) return "the guard has stopped the robot: " + fault;
  if (guard_.count() == known_faults_) return "";
  return "the guard had stopped the robot, and was cleared: " + guard_.last();
}

RosRobot::Motion RosRobot::begin(const Path& path, Way way) {
  const ContactObservation now = stream_.latest().value_or(ContactObservation{});
  const Pose& here = now.T_world_object;
  const Pose& target = path.empty() ? here : path.back();
  Motion motion{{now.time, here, target, 0.0}, now, now.contact_id, "", std::nullopt};
  if (const std::string fault = guardFault(); !fault.empty()) {
    motion.refused = MotionResult{MotionEnd::kFault, fault, 0.0};
    return motion;
  }
  const Result<std::vector<double>> joints = joints_.positionsAt(now.time);
  if (!joints) {
    motion.refused = MotionResult{MotionEnd::kFault, joints.reason(), 0.0};
    return motion;
  }
  Pose refused_at = here;
  const Result<JointTrajectory> trajectory =
      commands_->along(*joints, here, path, way, &refused_at);
  if (!trajectory) {
    ROS_WARN_STREAM("the robot cannot follow the path: " << trajectory.reason());
    motion.refused = MotionResult{MotionEnd::kUnreachable, trajectory.reason(), 0.0};
    motion.refused->refused_at = refused_at;
    return motion;
  }
  stream_.open();
  if (trajectory->points.empty()) return motion;
  motion.progress = {now.time, here, target, trajectory->points.back().time};
  send(*trajectory);
  return motion;
}

// Where tf and the arm's description differ, what they do so at the target is known only there.
void RosRobot::aimAgain(Motion* motion) {
  const Pose& here = motion->last.T_world_object;
  const Pose& target = motion->progress.target();
  if (motion->aims == kMostAims || gapBetween(here, target) > kNominalToolGap.distance) return;
  const Result<std::vector<double>> joints = joints_.positionsAt(motion->last.time);
  if (!joints) return;
  const Result<JointTrajectory> trajectory =
      commands_->along(*joints, here, {here, target}, Way::kNew);
  if (!trajectory || trajectory->points.empty()) return;
  ++motion->aims;
  motion->progress.setOutAgain(trajectory->points.back().time);
  send(*trajectory);
}

RosRobot::Step RosRobot::advance(Motion* motion) {
  const auto observation = nextObservation();
  if (stop_requested_ || !ros::ok()) {
    motion->reason = "stopped by the user";
    return Step::kFault;
  }
  motion->reason = guardFault();
  if (!motion->reason.empty()) return Step::kFault;
  if (!observation) {
    motion->reason =
        "no contact observation came for so long during a motion that the sensor must be "
        "taken for dead; are sensor, robot and force_torque node up?";
    return Step::kFault;
  }
  motion->last = *observation;
  sign_of_life_.publish(std_msgs::Empty());
  const MotionStage stage =
      motion->progress.update(observation->time, observation->T_world_object, speed_.scaling());
  if (observation->contact_id != motion->known_contacts) return Step::kContact;
  if (stage == MotionStage::kArrived) return Step::kArrived;
  if (stage == MotionStage::kStalled) return Step::kStalled;
  if (stage == MotionStage::kUnderWay) return Step::kGoOn;
  motion->reason = "the robot did not arrive in time; does it follow commands?";
  return Step::kFault;
}

// A trajectory without points is the command to stay here. It ends a motion that has arrived too: a
// guard whose last piece is late would wait for a sign of life that does not come.
void RosRobot::halt() { command_.publish(trajectory_msgs::JointTrajectory()); }

MotionResult RosRobot::endStopped(const Motion& motion) {
  halt();
  return end(motion, stop_requested_ ? MotionEnd::kStopped : MotionEnd::kFault);
}

MotionResult RosRobot::end(const Motion& motion, MotionEnd how) {
  stream_.close();
  MotionResult result;
  result.end = how;
  result.reason = motion.reason;
  result.length = motion.progress.length();
  return result;
}

MotionResult RosRobot::endInContact(Motion* motion) {
  halt();
  const Pose touched = motion->last.T_world_object;
  settleInContact(motion);
  const Path back = trail_.wayBack(touched, kWayOfWork);
  if (motion->last.line && !back.empty())
    motion->reason = sign_.contradiction(*motion->last.line, back.back(), touched);
  trail_.record(motion->last.T_world_object);  // it has run on
  return end(*motion, motion->reason.empty() ? MotionEnd::kContact : MotionEnd::kFault);
}

void RosRobot::settleInContact(Motion* motion) {
  SettleDeadline deadline;
  while (!motion->last.line && motion->last.state == ContactState::kContact &&
         !deadline.passedAt(motion->last.time)) {
    const auto observation = nextObservation();
    if (!observation) return;
    motion->last = *observation;
  }
}

}  // namespace smore
