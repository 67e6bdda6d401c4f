// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "force_torque_parameters.h"
#include "wrench_intake.h"

namespace smore {

/// The contact sensing of a listener once more, of wrenches and transforms that were recorded.
class SensingReplay {
 public:
  using OnObservation = std::function<void(const ContactObservation& observation)>;

  /// `events`: of that listener (smore/SensingEvents); none where they were not recorded. It tares
  /// with the first samples then. Observations are those that a listener would have published.
  SensingReplay(const ForceTorqueParameters& parameters,
                std::vector<smore_msgs::SensingEvent> events, OnObservation on_observation);

  void take(const geometry_msgs::WrenchStamped& message) { intake_.onWrench(message); }
  void take(const tf2_msgs::TFMessage& message, bool is_static);

  /// Stamp of the first sample; zero while there was none.
  const ros::Time& begin() const { return begin_; }

 private:
  void restart();
  void process(const WrenchSample& sample, const ros::Time& stamp);
  void applyEvents(const ros::Time& stamp);

  ForceTorqueParameters parameters_;
  std::vector<smore_msgs::SensingEvent> events_;
  std::size_t next_event_ = 0;
  OnObservation on_observation_;
  ContactSensing sensing_;
  ros::Time begin_;
  WrenchIntake intake_;
};

}  // namespace smore
