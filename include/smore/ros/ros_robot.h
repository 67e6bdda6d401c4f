// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <optional>
#include <string>

#include "smore/common/robot.h"
#include "smore/ros/conversions.h"
#include "smore/ros/observation_stream.h"

namespace smore {

struct RosRobotParameters {
  double linear_speed = 0.1;     ///< of the object frame, as the robot moves [m/s], positive
  double angular_speed = 0.5;    ///< [rad/s], positive
  double silence_timeout = 5.0;  ///< wall time without an observation that is a fault [s]
  double ready_timeout = 60.0;   ///< wall time to wait for a tared sensor at the start [s]
  std::string reset_service;     ///< sets the robot to the start; empty: it retreats all the way
};

/// A robot behind `command` and `contact`, whose observations say where it is and what it touches.
///
/// The robot stops at contact by its own reflex; this sends a stop as well. An arrival is a pose at
/// the end of the path that stays, not before the time that the path takes.
class RosRobot : public Robot {
 public:
  explicit RosRobot(const RosRobotParameters& parameters);

  /// Waits until the sensor is tared and touches nothing and the robot takes commands; what is
  /// missing where that does not come, else empty.
  std::string waitUntilReady();

  Pose pose() const override;
  MotionResult follow(const Path& path) override;
  MotionResult retreat(double distance) override;
  MotionResult reset(const Pose& start) override;

  /// Stamp of the newest observation [s]: maps that hold it know all that happened.
  double stamp() const;

  /// Ends the present motion and refuses further ones; from any thread.
  void requestStop();
  /// Allows motions again.
  void clearStop() { stop_requested_ = false; }

 private:
  enum class Step { kGoOn, kArrived, kContact, kFault };
  struct Motion;

  std::string missingBeside(const ContactObservation& observation);
  /// Nothing if none comes within the silence timeout, or the user asks for the stop meanwhile.
  std::optional<ContactObservation> nextObservation();
  Motion begin(const Path& path);
  Step advance(Motion* motion);
  void send(const Path& path);
  void halt();
  MotionResult end(const Motion& motion, MotionEnd how);
  void settleInContact(Motion* motion);
  bool waitUntilFree();
  bool waitUntilAt(const Pose& target);
  void recordTrail(const Pose& pose);
  Path takeTrail(double distance);

  RosRobotParameters parameters_;
  ObservationStream stream_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Publisher command_;
  ros::Subscriber contact_;
  ros::ServiceClient reset_;
  ros::AsyncSpinner spinner_{1, &queue_};
  Path trail_;  ///< way from the last reset to here
  std::atomic<bool> stop_requested_{false};
};

}  // namespace smore
