// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "smore/common/motion_progress.h"
#include "smore/common/robot.h"
#include "smore/common/trail.h"
#include "smore/contact/sign_check.h"
#include "smore/kinematics/joint_commands.h"
#include "smore/ros/conversions.h"
#include "smore/ros/fault_listener.h"
#include "smore/ros/fault_place.h"
#include "smore/ros/joint_listener.h"
#include "smore/ros/observation_stream.h"
#include "smore/ros/press_watch.h"
#include "smore/ros/speed_listener.h"

namespace smore {

struct RosRobotParameters {
  double silence_timeout = 5.0;  ///< wall time without an observation that is a fault [s]
  double ready_timeout = 60.0;   ///< wall time to wait for a tared sensor at the start [s]
  std::string zero_service;      ///< zeroes the driver's wrench before the tare; empty: none
  std::string reset_service;     ///< sets the robot to the start; empty: it retreats all the way
};

/// A robot behind `command`, `joint_states` and `contact`, whose observations say where the object
/// is and what it touches.
///
/// The robot stops at contact by its own reflex; this sends a stop as well.
class RosRobot : public Robot {
 public:
  RosRobot(const RosRobotParameters& parameters, std::unique_ptr<JointCommands> commands);

  /// Waits until the sensor is tared and touches nothing and the robot takes commands; what is
  /// missing where that does not come, else empty.
  std::string waitUntilReady();

  /// To be told of each goal's end. After one that failed in its motions, what presses until the
  /// object is free is what the robot met on its way. After one that did not, no way leads back: it
  /// would lead the object into what it has come out of.
  void endGoal(bool success) {
    press_.endGoal(success);
    if (success) trail_.clear();
  }

  /// Whether the object touches, when that was last known, what it met on its way, and the robot
  /// knows that way. A sensor that is not tared, or feels hardly anything, is no sign of a touch.
  bool canBackOff() const { return press_.pressesFromTheWay() && trail_.endsAt(pose()); }

  /// A fault of the guard that came before, and was cleared, ends nothing from now on; one that
  /// comes later does, cleared or not.
  void forgetFaults() { known_faults_ = guard_.count(); }

  /// Whether the guard lets nothing move.
  bool faulted() const { return !guard_.fault().empty(); }

  Pose pose() const override;
  /// In contact at once where something presses already: nothing moves. Where the sensor is unsure
  /// for long, as with a weight that it does not know, the motion sets out.
  MotionResult follow(const Path& path) override;
  MotionResult retreat(double distance) override;
  MotionResult reset(const Pose& start) override;

  /// Waits for `duration` [s of sample time, at most 2] while the robot stands; false where
  /// observations stay out or the user asks for the stop.
  bool standStill(double duration);

  /// Stamp of the newest observation [s]: maps that hold it know all that happened.
  double stamp() const;

  /// Ends the present motion and refuses further ones, and whatever waits returns; from any thread.
  void requestStop();
  bool stopRequested() const { return stop_requested_; }
  /// Allows motions again.
  void clearStop() { stop_requested_ = false; }
  /// Stops the robot where it is; from any thread.
  void halt();

 private:
  /// Between two looks at what comes and what the user wishes [s of wall time].
  static constexpr double kLookPeriod = 0.01;

  enum class Step { kGoOn, kArrived, kStalled, kContact, kFault };
  struct Motion;

  std::string missingBeside(const ContactObservation& observation);
  /// Why no motion may begin where tf has the tool; empty where one may.
  std::string toolProblem() const;
  /// Why the guard has stopped the robot since forgetFaults; empty: it has not.
  std::string guardFault() const;
  /// Nothing if none comes within the silence timeout, or the user asks for the stop meanwhile.
  std::optional<ContactObservation> nextObservation();
  Motion begin(const Path& path, Way way);
  Step advance(Motion* motion);
  /// Of the robot's program, which moves it.
  void onProgram(bool runs);
  /// Corrects a motion that stands close to its target.
  void aimAgain(Motion* motion);
  /// One motion along `back`, to its end or until the robot stands.
  MotionResult goBack(const Path& back);
  /// Sends a motion unless the user has asked for the stop.
  void send(const JointTrajectory& trajectory);
  MotionResult end(const Motion& motion, MotionEnd how);
  /// Stops the robot; by the user's wish or at a fault.
  MotionResult endStopped(const Motion& motion);
  /// Stops the robot and waits for the line.
  MotionResult endInContact(Motion* motion);
  void settleInContact(Motion* motion);
  bool pressesAtRest();
  bool waitUntilFree();
  bool waitUntilAt(const Pose& target);
  /// Until an observation fulfils the condition; false if none does within the deadline.
  bool waitUntil(const std::function<bool(const ContactObservation&)>& condition);

  RosRobotParameters parameters_;
  std::unique_ptr<JointCommands> commands_;
  ObservationStream stream_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  JointListener joints_;
  FaultListener guard_;
  SpeedListener speed_;
  FaultPlace fault_place_;
  PressWatch press_;
  ros::Publisher command_, sign_of_life_;
  ros::Subscriber contact_, program_;
  ros::ServiceClient reset_;
  ros::AsyncSpinner spinner_{1, &queue_};
  Trail trail_;  ///< since the last reset, or since the robot was moved by other means
  SignCheck sign_;
  std::mutex command_mutex_;  ///< so that no motion is sent after the stop that forbids it
  std::atomic<bool> stop_requested_{false};
  int known_faults_ = 0;      ///< of the guard
  bool program_runs_ = true;  ///< as far as was told; of the callbacks' thread
};

}  // namespace smore
