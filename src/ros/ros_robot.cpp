// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/ros_robot.h"

#include <std_srvs/Trigger.h>

#include <algorithm>
#include <limits>

#include "smore/ros/names.h"

namespace smore {
namespace {

// Sample times [s]: a contact settles, and a free sensor says so, in a tenth of this.
constexpr double kSettleDeadline = 2.0;
// A motion may take so many times what its speed says, and so much more [s], before it is a fault.
constexpr double kSlowness = 3.0;
constexpr double kSlack = 5.0;
// Shares of the motion's time before which no arrival counts: a path may cross its own end.
constexpr double kEarliest = 0.9;
// A robot at its target is this near [m + rad], and moved less than this during the last 10 ms.
constexpr double kAtTarget = 2e-3;
constexpr double kAtRest = 1e-4;
constexpr double kRestTime = 0.01;
constexpr double kTrailSpacing = 0.002;  // [m + rad] between the poses that a retreat retraces
// A retreat that touches is stopped by the reflex each time; more often it is stuck.
constexpr int kMostResumes = 50;

double gap(const Pose& a, const Pose& b) { return distanceBetween(a, b) + angleBetween(a, b); }

}  // namespace

struct RosRobot::Motion {
  Path path;
  double begin = 0.0;     ///< sample time of the command [s]
  double duration = 0.0;  ///< at the configured speed [s]
  int known_contacts = 0;
  double length = 0.0;
  ContactObservation last;
  Pose rest_pose = Pose::Identity();  ///< where it was when it last moved
  double rest_since = 0.0;
  std::string reason;
};

RosRobot::RosRobot(const RosRobotParameters& parameters) : parameters_(parameters) {
  node_.setCallbackQueue(&queue_);
  command_ =
      node_.advertise<trajectory_msgs::JointTrajectory>(names::kCommand, names::kLatestQueue);
  const boost::function<void(const smore_msgs::ContactObservation&)> on_contact =
      [this](const smore_msgs::ContactObservation& message) {
        const Result<ContactObservation> observation = fromMessage(message);
        if (observation) stream_.push(*observation);
      };
  contact_ = node_.subscribe<smore_msgs::ContactObservation>(
      names::kContact, names::kObservationQueue, on_contact, ros::VoidConstPtr(),
      ros::TransportHints().tcpNoDelay());
  if (!parameters_.reset_service.empty()) {
    reset_ = node_.serviceClient<std_srvs::Trigger>(parameters_.reset_service);
  }
  spinner_.start();
}

std::string RosRobot::waitUntilReady() {
  stream_.open();
  const ros::WallTime deadline =
      ros::WallTime::now() + ros::WallDuration(parameters_.ready_timeout);
  std::string missing = "no contact observations on '" + contact_.getTopic() +
                        "'; is the force_torque node up, and does it get wrenches and transforms?";
  while (ros::ok() && ros::WallTime::now() < deadline && !missing.empty()) {
    const auto observation = stream_.next(kRestTime);
    if (observation) missing = missingBeside(*observation);
  }
  stream_.close();
  return missing;
}

std::string RosRobot::missingBeside(const ContactObservation& observation) {
  if (observation.state != ContactState::kFree) {
    return "the sensor never says that the object is free; look at the force_torque node's log";
  }
  if (command_.getNumSubscribers() == 0) {
    return "nobody listens to commands on '" + command_.getTopic() + "'; is the robot up?";
  }
  if (!parameters_.reset_service.empty() && !reset_.exists()) {
    return "the service '" + reset_.getService() + "' does not appear; is the robot up?";
  }
  return "";
}

Pose RosRobot::pose() const {
  const auto latest = stream_.latest();
  return latest ? latest->T_world_object : Pose::Identity();
}

double RosRobot::stamp() const {
  const auto latest = stream_.latest();
  return latest ? latest->time : 0.0;
}

void RosRobot::requestStop() {
  stop_requested_ = true;
  halt();
}

MotionResult RosRobot::follow(const Path& path) {
  Motion motion = begin(path);
  while (true) {
    switch (advance(&motion)) {
      case Step::kGoOn:
        recordTrail(motion.last.T_world_object);
        break;
      case Step::kArrived:
        return end(motion, MotionEnd::kReached);
      case Step::kContact:
        halt();
        settleInContact(&motion);
        return end(motion, MotionEnd::kContact);
      case Step::kFault:
        halt();
        return end(motion, stop_requested_ ? MotionEnd::kStopped : MotionEnd::kFault);
    }
  }
}

MotionResult RosRobot::retreat(double distance) {
  const Path back = takeTrail(distance);
  if (back.empty()) return {};
  Motion motion = begin(back);
  for (int resumes = 0; resumes < kMostResumes;) {
    const Step step = advance(&motion);
    if (step == Step::kFault) {
      halt();
      return end(motion, stop_requested_ ? MotionEnd::kStopped : MotionEnd::kFault);
    }
    if (step == Step::kArrived) {
      if (waitUntilFree()) return end(motion, MotionEnd::kReached);
      break;
    }
    if (step == Step::kContact) {
      ++resumes;
      motion.known_contacts = motion.last.contact_id;
      const Pose here = motion.last.T_world_object;
      const auto nearest = std::min_element(
          back.begin(), back.end(),
          [&](const Pose& a, const Pose& b) { return gap(a, here) < gap(b, here); });
      send(Path(nearest, back.end()));
    }
  }
  halt();
  motion.reason = "still in contact after the retreat";
  return end(motion, MotionEnd::kFault);
}

MotionResult RosRobot::reset(const Pose& start) {
  if (parameters_.reset_service.empty()) {
    return retreat(std::numeric_limits<double>::infinity());
  }
  MotionResult result;
  std_srvs::Trigger call;
  stream_.open();
  if (!reset_.call(call) || !call.response.success) {
    result.reason = "the service '" + reset_.getService() + "' failed: " + call.response.message;
  } else if (!waitUntilAt(start)) {
    result.reason = "the robot did not come to the start";
  } else if (!waitUntilFree()) {
    result.reason = "the sensor feels a force at the start pose";
  }
  stream_.close();
  trail_.clear();
  if (!result.reason.empty()) result.end = MotionEnd::kFault;
  if (stop_requested_) result = {MotionEnd::kStopped, "stopped by the user", 0.0};
  return result;
}

std::optional<ContactObservation> RosRobot::nextObservation() {
  const ros::WallTime deadline =
      ros::WallTime::now() + ros::WallDuration(parameters_.silence_timeout);
  while (ros::ok() && !stop_requested_ && ros::WallTime::now() < deadline) {
    if (auto observation = stream_.next(kRestTime)) return observation;
  }
  return std::nullopt;
}

RosRobot::Motion RosRobot::begin(const Path& path) {
  Motion motion;
  motion.path = path;
  motion.last = stream_.latest().value_or(ContactObservation{});
  motion.begin = motion.last.time;
  motion.rest_pose = motion.last.T_world_object;
  motion.rest_since = motion.begin;
  motion.known_contacts = motion.last.contact_id;
  Pose from = motion.last.T_world_object;
  for (const Pose& to : path) {
    motion.duration += std::max(distanceBetween(from, to) / parameters_.linear_speed,
                                angleBetween(from, to) / parameters_.angular_speed);
    from = to;
  }
  stream_.open();
  if (!stop_requested_) send(path);
  return motion;
}

RosRobot::Step RosRobot::advance(Motion* motion) {
  const auto observation = nextObservation();
  if (stop_requested_ || !ros::ok()) {
    motion->reason = "stopped by the user";
    return Step::kFault;
  }
  if (!observation) {
    motion->reason =
        "no contact observation came for so long during a motion that the sensor must be "
        "taken for dead; are sensor, robot and force_torque node up?";
    return Step::kFault;
  }
  const Pose& here = observation->T_world_object;
  motion->length += distanceBetween(motion->last.T_world_object, here);
  motion->last = *observation;
  if (observation->contact_id != motion->known_contacts) return Step::kContact;
  if (gap(motion->rest_pose, here) > kAtRest) {
    motion->rest_pose = here;
    motion->rest_since = observation->time;
  }
  const double elapsed = observation->time - motion->begin;
  const bool at_rest = observation->time - motion->rest_since >= kRestTime;
  if (at_rest && elapsed >= kEarliest * motion->duration &&
      (motion->path.empty() || gap(here, motion->path.back()) < kAtTarget)) {
    return Step::kArrived;
  }
  if (elapsed > kSlowness * motion->duration + kSlack) {
    motion->reason = "the robot did not arrive in time; does it follow commands?";
    return Step::kFault;
  }
  return Step::kGoOn;
}

void RosRobot::send(const Path& path) {
  command_.publish(toTrajectory(path, parameters_.linear_speed, parameters_.angular_speed));
}

void RosRobot::halt() { send({}); }

MotionResult RosRobot::end(const Motion& motion, MotionEnd how) {
  stream_.close();
  MotionResult result;
  result.end = how;
  result.reason = motion.reason;
  result.length = motion.length;
  return result;
}

void RosRobot::settleInContact(Motion* motion) {
  const double deadline = motion->last.time + kSettleDeadline;
  while (!motion->last.line && motion->last.state == ContactState::kContact &&
         motion->last.time < deadline) {
    const auto observation = nextObservation();
    if (!observation) return;
    motion->last = *observation;
  }
}

bool RosRobot::waitUntilFree() {
  std::optional<double> deadline;
  while (const auto observation = nextObservation()) {
    if (observation->state == ContactState::kFree) return true;
    if (!deadline) deadline = observation->time + kSettleDeadline;
    if (observation->time > *deadline) return false;
  }
  return false;
}

bool RosRobot::waitUntilAt(const Pose& target) {
  std::optional<double> deadline;
  while (const auto observation = nextObservation()) {
    if (gap(observation->T_world_object, target) < kAtTarget) return true;
    if (!deadline) deadline = observation->time + kSettleDeadline;
    if (observation->time > *deadline) return false;
  }
  return false;
}

void RosRobot::recordTrail(const Pose& pose) {
  if (trail_.empty() || gap(trail_.back(), pose) >= kTrailSpacing) trail_.push_back(pose);
}

Path RosRobot::takeTrail(double distance) {
  Path back;
  Pose last = pose();
  double travelled = 0.0;
  while (!trail_.empty() && travelled < distance) {
    travelled += gap(last, trail_.back());
    last = trail_.back();
    back.push_back(last);
    trail_.pop_back();
  }
  return back;
}

}  // namespace smore
