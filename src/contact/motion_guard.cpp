// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/motion_guard.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace smore {
namespace {

// A joint may be where its motion was so long ago: two ways over a network, and what the controller
// takes to pass from one piece of the motion to the next [s].
constexpr double kLag = 0.1;

constexpr char kProgramEnded[] =
    "the robot's program does not run: it ended, or a protective or emergency stop ended it; press "
    "Play when the cause is gone";

bool allFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

std::string above(const std::string& what, double value, double limit, const std::string& unit) {
  std::ostringstream text;
  text.precision(3);
  text << what << " is " << value << " " << unit << ", above the limit of " << limit << " " << unit;
  return text.str();
}

std::string milliseconds(double seconds) {
  return std::to_string(std::lround(1e3 * seconds)) + " ms";
}

// The values of `joints` among those of `names`; nothing where one is missing.
std::optional<std::vector<double>> pick(const std::vector<std::string>& joints,
                                        const std::vector<std::string>& names,
                                        const std::vector<double>& values) {
  std::vector<double> picked;
  for (const std::string& joint : joints) {
    const auto place = std::find(names.begin(), names.end(), joint);
    const auto index = static_cast<size_t>(place - names.begin());
    if (place == names.end() || index >= values.size()) return std::nullopt;
    picked.push_back(values[index]);
  }
  return picked;
}

// The trajectory with its joints in the order of `joints`; nothing where one is missing, another is
// among them, or velocities are given for some of the joints.
std::optional<JointTrajectory> ordered(const JointTrajectory& trajectory,
                                       const std::vector<std::string>& joints) {
  if (trajectory.joint_names.size() != joints.size()) return std::nullopt;
  JointTrajectory result{joints, {}};
  for (const JointTrajectoryPoint& point : trajectory.points) {
    const auto positions = pick(joints, trajectory.joint_names, point.positions);
    const auto velocities = point.velocities.empty()
                                ? std::vector<double>()
                                : pick(joints, trajectory.joint_names, point.velocities);
    if (!positions || !velocities) return std::nullopt;
    result.points.push_back({point.time, *positions, *velocities});
  }
  return result;
}

// Greatest speed on the cubic from velocity v0 to v1 that goes at `mean` on average. At the share s
// of its time it is v0 + (6 mean - 4 v0 - 2 v1) s + 3 (v0 + v1 - 2 mean) s^2.
double greatestSpeed(double v0, double v1, double mean) {
  const double slope = 6.0 * mean - 4.0 * v0 - 2.0 * v1;
  const double bend = 3.0 * (v0 + v1 - 2.0 * mean);
  const double ends = std::max(std::abs(v0), std::abs(v1));
  const double share = bend == 0.0 ? 0.0 : -slope / (2.0 * bend);
  if (share <= 0.0 || share >= 1.0) return ends;
  return std::max(ends, std::abs(v0 + 0.5 * slope * share));
}

// Without velocities at both ends the way between two points is straight.
double greatestSpeed(const JointTrajectoryPoint& from, const JointTrajectoryPoint& to,
                     size_t joint) {
  const double mean = (to.positions[joint] - from.positions[joint]) / (to.time - from.time);
  if (from.velocities.empty() || to.velocities.empty()) return std::abs(mean);
  return greatestSpeed(from.velocities[joint], to.velocities[joint], mean);
}

}  // namespace

bool MotionGuard::Ceiling::exceededBy(double value) {
  allowed_ = std::max(limit_, std::min(allowed_, value + margin_));
  return value > allowed_;
}

void MotionGuard::Ceiling::raiseTo(double value) { allowed_ = std::max(limit_, value + margin_); }

// Above the limit there is a retreat, which goes on.
void MotionGuard::Ceiling::limitTo(double limit) {
  if (allowed_ <= limit_) allowed_ = limit;
  limit_ = limit;
}

void MotionGuard::Heartbeat::beat(double new_measured, double new_stamp) {
  if (stamp == new_stamp) return;
  stamp = new_stamp;
  measured = new_measured;
}

MotionGuard::MotionGuard(const MotionGuardParameters& parameters,
                         std::vector<std::string> joint_names)
    : parameters_(parameters),
      joint_names_(std::move(joint_names)),
      force_(parameters.limits.max_force, parameters.force_margin),
      torque_(parameters.limits.max_torque, parameters.torque_margin) {}

void MotionGuard::limitTo(const MotionLimits& limits) {
  parameters_.limits = limits;
  force_.limitTo(limits.max_force);
  torque_.limitTo(limits.max_torque);
}

void MotionGuard::onWrench(double measured, double stamp, const Wrench& wrench) {
  wrench_beat_.beat(measured, stamp);
  if (!isFinite(wrench)) return stop("a wrench has a value that is not finite");
  const bool same = wrench.force == wrench_.force && wrench.torque == wrench_.torque;
  if (!same) wrench_changed_ = measured;
  wrench_ = wrench;
  const double force = wrench.force.norm();
  const double torque = wrench.torque.norm();
  if (force_.exceededBy(force)) stop(above("the force", force, force_.allowed(), "N"));
  if (torque_.exceededBy(torque)) stop(above("the torque", torque, torque_.allowed(), "N m"));
}

void MotionGuard::onJoints(double measured, const JointReading& reading) {
  const auto positions = pick(joint_names_, reading.names, reading.positions);
  const auto velocities = pick(joint_names_, reading.names, reading.velocities);
  if (!positions) return;
  if (!velocities) return stop("the joint states have no velocities; the driver must give them");
  joints_beat_.beat(measured, reading.stamp);
  if (!allFinite(*positions) || !allFinite(*velocities)) {
    return stop("a joint state has a value that is not finite");
  }
  state_ = {reading.stamp, *positions, *velocities};
  for (size_t i = 0; i < joint_names_.size(); ++i) {
    const double speed = std::abs((*velocities)[i]);
    if (speed > parameters_.limits.max_joint_speed) {
      stop(above("the speed of " + joint_names_[i], speed, parameters_.limits.max_joint_speed,
                 "rad/s"));
    }
  }
}

std::optional<JointTrajectory> MotionGuard::admit(double now, const JointTrajectory& trajectory) {
  check(now);
  if (!fault_.empty()) return std::nullopt;
  const std::string problem = problemOf(trajectory);
  if (!problem.empty()) stop(problem);
  if (!problem.empty()) return std::nullopt;
  onSignOfLife(now);
  JointTrajectory motion = *ordered(trajectory, joint_names_);
  const std::vector<double> still(joint_names_.size(), 0.0);
  if (motion.points.empty() || motion.points.front().time > 0.0) {
    motion.points.insert(motion.points.begin(), {0.0, state_.positions, still});
  }
  return motion;
}

void MotionGuard::check(double now) {
  settleWrench(now);
  const std::string problem = silence(now, parameters_.max_silence);
  if (!problem.empty()) stop(problem);
  if (!safety_stop_.empty()) {
    if (fault_ == kProgramEnded) fault_.clear();  // this says why
    stop(safety_stop_);
  }
  if (!program_runs_) stop(kProgramEnded);
}

void MotionGuard::settleWrench(double now) {
  if (now <= checked_) return;
  checked_ = now;
  settled_wrench_ = std::exchange(newest_wrench_, wrench_beat_.stamp);
}

void MotionGuard::onProgram(bool running) { program_runs_ = running; }

void MotionGuard::checkMotion(double now, const JointTrajectoryPoint& expected) {
  check(now);
  const std::string nobody = unattended(now, parameters_.max_silence);
  if (!nobody.empty()) stop(nobody);
  const std::string problem = problemOfMotion(expected);
  if (!problem.empty()) stop(problem);
}

std::string MotionGuard::lateness(double now) const {
  const std::string problem = silence(now, parameters_.max_lateness);
  return problem.empty() ? unattended(now, parameters_.max_lateness) : problem;
}

std::optional<JointTrajectoryPoint> MotionGuard::joints(double now) const {
  if (!joints_beat_.stamp || now - joints_beat_.measured > parameters_.max_lateness) {
    return std::nullopt;
  }
  return state_;
}

void MotionGuard::stop(const std::string& reason) {
  if (fault_.empty()) fault_ = reason;
}

void MotionGuard::clear(double now) {
  fault_.clear();
  force_.raiseTo(wrench_.force.norm());
  torque_.raiseTo(wrench_.torque.norm());
  check(now);
}

std::string MotionGuard::unattended(double now, double most) const {
  if (now - commander_ <= most) return "";
  return "no sign of life of who commanded the motion for over " + milliseconds(most) +
         "; is the retrieval node up?";
}

std::string MotionGuard::silence(double now, double most) const {
  const auto silent = [&](const Heartbeat& stream) {
    return stream.stamp && now - stream.measured > most;
  };
  const std::string suffix = " younger than " + milliseconds(most) +
                             "; are driver and network up, and their clock the same as here?";
  if (silent(wrench_beat_)) return "no wrench" + suffix;
  if (silent(joints_beat_)) return "no joint states" + suffix;
  if (parameters_.wrench_varies && wrench_beat_.stamp && now - wrench_changed_ > most) {
    return "the wrench has been the same for over " + milliseconds(most) +
           ", as no sensor with noise says; is the connection to the robot cut?";
  }
  const bool behind =
      contact_beat_.stamp && settled_wrench_ && *settled_wrench_ - *contact_beat_.stamp > most;
  if (silent(contact_beat_) || behind) {
    return "the contact observations are late by over " + milliseconds(most) +
           "; is the force_torque node up, and does it get transforms?";
  }
  return "";
}

std::string MotionGuard::problemOf(const JointTrajectory& trajectory) const {
  if (!wrench_beat_.stamp) return "a motion was commanded before any wrench came";
  if (state_.positions.empty()) return "a motion was commanded before any joint states came";
  if (!contact_beat_.stamp) return "a motion was commanded before the listener had tared";
  const auto motion = ordered(trajectory, joint_names_);
  if (!motion) return "the commanded trajectory is not one of all of the robot's joints";
  for (const JointTrajectoryPoint& point : motion->points) {
    if (!std::isfinite(point.time) || !allFinite(point.positions) || !allFinite(point.velocities)) {
      return "the commanded trajectory has a value that is not finite";
    }
  }
  return problemOfPoints(*motion);
}

std::string MotionGuard::problemOfPoints(const JointTrajectory& ordered) const {
  // Where the trajectory does not begin now, the motion begins at rest (admit).
  JointTrajectoryPoint last{0.0, state_.positions, std::vector<double>(joint_names_.size(), 0.0)};
  for (size_t place = 0; place < ordered.points.size(); ++place) {
    const JointTrajectoryPoint& point = ordered.points[place];
    const bool is_start = place == 0 && point.time == 0.0;
    if (!is_start && point.time <= last.time) return "the commanded trajectory's times do not rise";
    for (size_t i = 0; i < joint_names_.size(); ++i) {
      const double away = std::abs(point.positions[i] - state_.positions[i]);
      if (is_start && away > parameters_.path_tolerance) {
        return above("the distance of " + joint_names_[i] + " from the commanded start", away,
                     parameters_.path_tolerance, "rad");
      }
      const double speed = is_start ? 0.0 : greatestSpeed(last, point, i);
      if (speed > parameters_.limits.max_joint_speed) {
        return above("the commanded speed of " + joint_names_[i], speed,
                     parameters_.limits.max_joint_speed, "rad/s");
      }
    }
    last = point;
  }
  const auto moves = [](double velocity) { return velocity != 0.0; };
  if (std::any_of(last.velocities.begin(), last.velocities.end(), moves)) {
    return "the commanded trajectory does not end at rest";
  }
  return "";
}

std::string MotionGuard::problemOfMotion(const JointTrajectoryPoint& expected) const {
  for (size_t i = 0; i < joint_names_.size(); ++i) {
    const double away = std::abs(state_.positions[i] - expected.positions[i]);
    const double allowed = parameters_.path_tolerance + kLag * std::abs(expected.velocities[i]);
    if (away > allowed) {
      return above("the distance of " + joint_names_[i] + " from its motion", away, allowed,
                   "rad") +
             "; does the robot follow commands?";
    }
  }
  return "";
}

}  // namespace smore
