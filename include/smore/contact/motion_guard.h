// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/joint_trajectory.h"

namespace smore {

/// What nothing may be above; may be changed while a robot is guarded.
struct MotionLimits {
  double max_force = 40.0;       ///< of a raw sample, weight and bias included [N]
  double max_torque = 8.0;       ///< the same, about the sensor's origin [N m]
  double max_joint_speed = 2.0;  ///< measured and commanded, of each joint [rad/s] or [m/s]
};

struct MotionGuardParameters {
  MotionLimits limits;
  /// Age of the newest of a stream, or of the sign of life of who commanded a motion, at which the
  /// motion waits, and at which it is a fault [s].
  double max_lateness = 0.05;
  double max_silence = 0.2;
  /// Of each joint, to where a motion starts, and to where it should be in it [rad] or [m]; a joint
  /// that moves may be late by a tenth of a second on top of it.
  double path_tolerance = 0.03;
  /// After a fault is cleared under load, force and torque may rise above the least since then by
  /// this much [N], [N m]; sensor noise must be smaller.
  double force_margin = 10.0;
  double torque_margin = 1.0;
  /// Whether two samples of the wrench in succession are never the same, as those of a sensor with
  /// noise: a driver without a robot may repeat the last one under fresh stamps.
  bool wrench_varies = false;
};

/// Joints as a driver reports them; lists of equal length.
struct JointReading {
  double stamp = 0.0;  ///< [s]
  std::vector<std::string> names;
  std::vector<double> positions;   ///< [rad] or [m]
  std::vector<double> velocities;  ///< [rad/s] or [m/s]
};

/// Decides whether a robot may move. It latches the first fault with its reason, whether a motion
/// runs or not: force, torque or joint speed above the limit, a value that is not finite, a stream
/// (wrenches, joint states, contact observations) that was there and falls silent or repeats
/// itself, a trajectory that is too fast or does not start at the joints. While a motion runs, its
/// commander must show that it lives, and the joints must follow.
///
/// A computer that is busy for a moment is no fault: where streams or commander are merely late, a
/// motion has to wait, blind as it is, and goes on when they are not.
///
/// All `now` and `measured` are of one clock that never jumps [s]; `measured` is when a message's
/// values were new, by the age of its stamp. A message whose stamp is that of the one before counts
/// as silence.
class MotionGuard {
 public:
  /// `joint_names`: the joints that count; others (a gripper's) on the same stream do not.
  MotionGuard(const MotionGuardParameters& parameters, std::vector<std::string> joint_names);

  /// Other limits from the next sample, joint state or command on. While the robot retreats under
  /// load, a lower ceiling of force or torque takes hold as they fall, as after the clearing.
  void limitTo(const MotionLimits& limits);

  const MotionLimits& limits() const { return parameters_.limits; }

  void onWrench(double measured, double stamp, const Wrench& wrench);

  /// A reading without all of the robot's joints is another device's and says nothing.
  void onJoints(double measured, const JointReading& reading);

  /// Whether the robot's own program runs, without which it takes no commands; true until told.
  void onProgram(bool running);

  /// Why the robot's own safety system does not let it move; empty: it does, as until told. It
  /// takes the place of the fault that the program has ended, whichever is told first.
  void onSafetyStop(const std::string& reason) { safety_stop_ = reason; }

  /// A contact observation of the wrench of this stamp. It needs the object's pose at the stamp: it
  /// is late too where tf stands still, however fresh other stamps are. Before the first that is
  /// `sure` whether something touches the listener has not tared: it starts up, unevenly, and its
  /// observations do not count yet.
  void onContact(double measured, double stamp, bool sure) {
    if (sure || contact_beat_.stamp) contact_beat_.beat(measured, stamp);
  }

  /// Who commanded the motion lives and wants it to go on.
  void onSignOfLife(double now) { commander_ = std::max(commander_, now); }

  /// The motion of a commanded trajectory: its joints in the order of the robot's, from a point at
  /// time 0 on. Where the robot may not follow it, nothing: `fault` says why. A first point at time
  /// 0 is where the motion starts; before a later one the robot moves there from where it stands.
  std::optional<JointTrajectory> admit(double now, const JointTrajectory& trajectory);

  /// Looks for silence; to be called several times in `max_lateness`. Here and below, all that had
  /// come by `now` must have been handed over: who was held up himself has heard nothing, and takes
  /// that for silence.
  void check(double now);

  /// Looks for what must not be while a motion runs, that should have come to `expected` by now; to
  /// be called as often.
  void checkMotion(double now, const JointTrajectoryPoint& expected);

  /// Why a motion that runs must wait for now; empty: it need not.
  std::string lateness(double now) const;

  /// Where the joints are and how fast, in the order of the names, its time their stamp; nothing
  /// where that is older than `max_lateness`.
  std::optional<JointTrajectoryPoint> joints(double now) const;
  /// The same as long as it is no older than 0.05 s, too: a brake leads back to where the joints
  /// were, in no more time than it takes, and would throw an arm that has gone on for longer.
  std::optional<JointTrajectoryPoint> jointsToBrakeFrom(double now) const {
    constexpr double kOldest = 0.05;  // about the shortest brake, and the default max_lateness
    return now - joints_beat_.measured > kOldest ? std::nullopt : joints(now);
  }

  /// Latches a fault of the caller's own, such as a user's stop.
  void stop(const std::string& reason);

  /// Forgets the fault. Force and torque above their ceilings are allowed as long as they fall, so
  /// that the robot can retreat. What is wrong still is a fault again at once.
  void clear(double now);

  /// The first fault since the last clearing; empty: the robot may move.
  const std::string& fault() const { return fault_; }

 private:
  /// A limit that follows a value down, from a clearing above it to the limit itself.
  class Ceiling {
   public:
    Ceiling(double limit, double margin) : limit_(limit), margin_(margin), allowed_(limit) {}
    bool exceededBy(double value);
    void raiseTo(double value);
    void limitTo(double limit);
    double allowed() const { return allowed_; }

   private:
    double limit_, margin_, allowed_;
  };

  /// When a stream last said something new.
  struct Heartbeat {
    std::optional<double> stamp;
    double measured = 0.0;
    void beat(double new_measured, double new_stamp);
  };

  void settleWrench(double now);
  std::string silence(double now, double most) const;
  std::string unattended(double now, double most) const;
  std::string problemOf(const JointTrajectory& trajectory) const;
  std::string problemOfPoints(const JointTrajectory& ordered) const;
  std::string problemOfMotion(const JointTrajectoryPoint& expected) const;

  MotionGuardParameters parameters_;
  std::vector<std::string> joint_names_;
  Ceiling force_, torque_;
  Wrench wrench_;               ///< the last finite one
  JointTrajectoryPoint state_;  ///< the last finite one, in the order of joint_names_
  Heartbeat wrench_beat_, joints_beat_, contact_beat_;
  double wrench_changed_ = 0.0;  ///< when it was last another than before
  /// Stamps of the newest wrench by the last check, and by the one before it, checks of one time
  /// counting once: a contact observation is compared with the latter, as it may be handed over
  /// after wrenches that came with it.
  std::optional<double> newest_wrench_, settled_wrench_;
  double checked_ = std::numeric_limits<double>::lowest();  ///< the time of the last check
  bool program_runs_ = true;
  std::string safety_stop_;  ///< of the robot itself; empty: none
  double commander_ = 0.0;   ///< when its last sign of life came
  std::string fault_;
};

}  // namespace smore
