// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "force_torque_parameters.h"
#include "smore/contact/sample_rate.h"
#include "smore/ros/leap_filter.h"
#include "smore/ros/listener_status.h"
#include "smore/ros/throttle.h"
#include "smore/ros/wrist_poses.h"

namespace smore {

/// Keeps wrenches until the pose at their own stamps is known, and leaves out, with a warning now
/// and then, what cannot be used: stamps that repeat or stray (LeapFilter), frames that tf cannot
/// know, poses that do not come in time.
class WrenchIntake {
 public:
  using OnSample = std::function<void(const WrenchSample& sample, const ros::Time& stamp)>;

  /// `on_restart` is called after time went back: a recording begins again, or a simulator does.
  WrenchIntake(const ForceTorqueParameters& parameters, std::function<void()> on_restart,
               OnSample on_sample);

  void onWrench(const geometry_msgs::WrenchStamped& message);
  void onTransforms(const tf2_msgs::TFMessage& message);
  void onStaticTransforms(const tf2_msgs::TFMessage& message);

  /// Hands on the wrenches, oldest first, up to the first one that still waits for its pose.
  void handOn();

  /// Seconds of wall time since the last wrench came, usable or not, or since the beginning.
  double silence() const { return (ros::WallTime::now() - last_arrival_).toSec(); }

  /// What there is to say of the stream now.
  WrenchReport report() const;

  /// Samples at the end of the sensor's range, since the beginning.
  std::uint64_t saturated() const { return saturated_; }

 private:
  /// What of a stream is to be handled now, with a warning that names it where one strayed.
  template <typename Message>
  std::vector<Message> throughLeaps(const Message& message, const std::string& name,
                                    LeapFilter<Message>* leaps);
  void takeWrench(const geometry_msgs::WrenchStamped& message);
  void takeTransforms(const tf2_msgs::TFMessage& message);
  void takeOverdue();
  void restart();
  double waited() const;
  bool expired() const;
  void watchRate(double time);

  static constexpr double kWarningPeriod = 5.0;  // [s] between warnings of one kind

  ForceTorqueParameters parameters_;
  std::function<void()> on_restart_;
  OnSample on_sample_;
  LeapFilter<geometry_msgs::WrenchStamped> wrench_leaps_;
  /// By the frame that is placed.
  std::map<std::string, LeapFilter<geometry_msgs::TransformStamped>> transform_leaps_;
  WristPoses poses_;
  std::deque<geometry_msgs::WrenchStamped> waiting_;  ///< for their poses, oldest first
  ros::WallTime last_arrival_ = ros::WallTime::now();
  ros::Time last_stamp_;                         ///< of the newest wrench that came
  std::map<std::string, ros::Time> last_poses_;  ///< of the newest transform, by its frame
  SampleRate rate_;
  bool rate_told_ = false;
  std::uint64_t received_ = 0, saturated_ = 0;
  DroppedWrenches dropped_;
  Throttle repeated_warning_{kWarningPeriod}, frame_warning_{kWarningPeriod};
  Throttle pose_warning_{kWarningPeriod}, transform_warning_{kWarningPeriod};
  Throttle stray_warning_{kWarningPeriod};
};

}  // namespace smore
