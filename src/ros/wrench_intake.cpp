// SPDX-License-Identifier: BSD-3-Clause
#include "wrench_intake.h"

#include <ros/ros.h>

#include <utility>

#include "smore/ros/names.h"

namespace smore {

using geometry_msgs::TransformStamped;

namespace {

constexpr double kFarRate = 1.5;  // times the period that the parameters say, or its inverse

// In seconds: a duration does not hold the difference of any two times.
bool wentBack(const ros::Time& stamp, const ros::Time& last) {
  constexpr double kTimeJump = LeapFilter<geometry_msgs::WrenchStamped>::kLeap;
  return stamp.toSec() + kTimeJump < last.toSec();
}

void warnOfDropped(const geometry_msgs::WrenchStamped& message, const std::string& problem,
                   Throttle* warning) {
  if (warning->isDue())
    ROS_WARN_STREAM("wrench at " << message.header.stamp << " s dropped: " << problem);
}

void warnOfTransform(const std::string& problem, Throttle* warning) {
  if (!problem.empty() && warning->isDue()) ROS_WARN_STREAM(problem);
}

}  // namespace

WrenchIntake::WrenchIntake(const ForceTorqueParameters& parameters,
                           std::function<void()> on_restart, OnSample on_sample)
    : parameters_(parameters),
      on_restart_(std::move(on_restart)),
      on_sample_(std::move(on_sample)),
      poses_(parameters.frames) {}

template <typename Message>
std::vector<Message> WrenchIntake::throughLeaps(const Message& message, const std::string& name,
                                                LeapFilter<Message>* leaps) {
  const std::uint64_t dropped = leaps->dropped();
  std::vector<Message> through = leaps->take(message);
  if (leaps->dropped() > dropped && stray_warning_.isDue())
    ROS_WARN_STREAM("of '" << name
                           << "' one dropped: its stamp is seconds from those before and "
                              "after it; who stamps it, and by which clock?");
  return through;
}

void WrenchIntake::onWrench(const geometry_msgs::WrenchStamped& message) {
  last_arrival_ = ros::WallTime::now();
  ++received_;
  for (const auto& through : throughLeaps(message, names::kWrench, &wrench_leaps_))
    takeWrench(through);
}

void WrenchIntake::takeWrench(const geometry_msgs::WrenchStamped& message) {
  const ros::Time& stamp = message.header.stamp;
  if (wentBack(stamp, last_stamp_)) restart();
  if (stamp <= last_stamp_) {
    ++dropped_.repeated;
    return warnOfDropped(message,
                         "it is not newer than the one before; do its stamps jitter, or who else "
                         "publishes?",
                         &repeated_warning_);
  }
  const std::string problem = frameNameProblem(message.header.frame_id);
  if (!problem.empty()) {
    ++dropped_.frameless;
    return warnOfDropped(message, problem, &frame_warning_);
  }
  last_stamp_ = stamp;
  const Wrench wrench = inFrame(parameters_.axes, fromMessage(message.wrench));
  if (isSaturated(wrench, parameters_.range)) ++saturated_;
  waiting_.push_back(message);
  waiting_.back().wrench = toMessage(wrench);
  watchRate(stamp.toSec());
}

void WrenchIntake::onTransforms(const tf2_msgs::TFMessage& message) {
  tf2_msgs::TFMessage believed;
  for (const TransformStamped& transform : message.transforms) {
    const std::string& frame = transform.child_frame_id;
    for (const auto& through : throughLeaps(transform, frame, &transform_leaps_[frame])) {
      believed.transforms.push_back(through);
    }
  }
  takeTransforms(believed);
}

void WrenchIntake::takeTransforms(const tf2_msgs::TFMessage& message) {
  for (const TransformStamped& transform : message.transforms) {
    const std::string& frame = transform.child_frame_id;
    const auto last = last_poses_.find(frame);
    const bool went_back =
        last != last_poses_.end() && wentBack(transform.header.stamp, last->second);
    if (went_back && poses_.carriesObject(frame)) restart();
    last_poses_[frame] = transform.header.stamp;
  }
  warnOfTransform(poses_.add(message, false), &transform_warning_);
}

void WrenchIntake::takeOverdue() {
  if (const auto wrench = wrench_leaps_.overdue()) takeWrench(*wrench);
  tf2_msgs::TFMessage transforms;
  for (auto& [frame, leaps] : transform_leaps_) {
    if (const auto transform = leaps.overdue()) transforms.transforms.push_back(*transform);
  }
  takeTransforms(transforms);
}

void WrenchIntake::onStaticTransforms(const tf2_msgs::TFMessage& message) {
  warnOfTransform(poses_.add(message, true), &transform_warning_);
}

void WrenchIntake::handOn() {
  takeOverdue();
  while (!waiting_.empty()) {
    const geometry_msgs::WrenchStamped& first = waiting_.front();
    const Result<WrenchSample> sample = poses_.sampleOf(first);
    if (sample) {
      on_sample_(*sample, first.header.stamp);
    } else if (!poses_.begunAfter(first.header.stamp, parameters_.transform_timeout)) {
      if (!expired()) return;
      ++dropped_.poseless;
      warnOfDropped(first, sample.reason(), &pose_warning_);
    }
    waiting_.pop_front();
  }
}

void WrenchIntake::restart() {
  ROS_WARN("time went back: forgetting wrenches and transforms, and taring anew");
  waiting_.clear();
  poses_.clear();
  last_stamp_ = ros::Time();
  last_poses_.clear();
  rate_ = SampleRate();
  on_restart_();
}

// How much newer wrenches are than the first one that waits [s].
double WrenchIntake::waited() const {
  if (waiting_.empty()) return 0.0;
  return waiting_.back().header.stamp.toSec() - waiting_.front().header.stamp.toSec();
}

// Whether the first wrench waited too long, or too many wait.
bool WrenchIntake::expired() const {
  return waited() > parameters_.transform_timeout || waiting_.size() >= names::kStreamQueue;
}

WrenchReport WrenchIntake::report() const {
  WrenchReport report;
  report.received = received_;
  report.silence = silence();
  report.silence_timeout = parameters_.silence_timeout;
  report.period = rate_.period();
  report.jitter = rate_.jitter();
  report.told_period = parameters_.sensing.noise.sample_period;
  report.waiting = waited();
  report.dropped = dropped_;
  report.dropped.stray = wrench_leaps_.dropped();
  return report;
}

void WrenchIntake::watchRate(double time) {
  rate_.add(time);
  const double told = parameters_.sensing.noise.sample_period;
  const double ratio = rate_.period().value_or(told) / told;
  const bool far = ratio > kFarRate || ratio < 1.0 / kFarRate;
  if (far && !rate_told_)
    ROS_WARN_STREAM("wrenches come every " << *rate_.period() << " s, noise/sample_period says "
                                           << told << " s; correct it there (sample_period:= of "
                                           << "the launch files), or find out why");
  rate_told_ = far;
}

}  // namespace smore
