// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"
#include "smore/simulation/delayed_zero.h"

namespace smore {

/// What is set on an arm's pendant, in the frame of the flange.
struct PendantSettings {
  Vec3 tcp = Vec3::Zero();             ///< tool centre point [m]
  double payload_mass = 0.0;           ///< [kg]
  Vec3 payload_center = Vec3::Zero();  ///< of mass [m]
};

/// The wrench as Universal Robots' driver for ROS 1 publishes it: the controller takes off the
/// weight of the payload that is set and then the zero, and the driver moves it to the TCP the
/// wrong way round, by T_flange_tcp instead of its inverse: with a TCP p a line of action lies 2p
/// off.
class DriverWrench {
 public:
  explicit DriverWrench(const PendantSettings& settings) : settings_(settings) {}

  /// The sensor is zeroed at the time `at` [s], by the mean since the call.
  void askForZero(double at) { zero_.ask(at); }

  /// What is published for what the sensor feels at `now` [s] about the flange, in its axes, the
  /// flange standing at T_world_flange.
  Wrench at(double now, const Wrench& felt, const Pose& T_world_flange) {
    const Vec3 weight = T_world_flange.linear().transpose() * (settings_.payload_mass * gravity());
    Wrench wrench = felt;
    wrench.force -= weight;
    wrench.torque -= settings_.payload_center.cross(weight);
    zero_.observe(now, wrench);
    wrench.force -= zero_.offset().force;
    wrench.torque -= zero_.offset().torque;
    wrench.torque += settings_.tcp.cross(wrench.force);
    return wrench;
  }

 private:
  PendantSettings settings_;
  DelayedZero zero_;
};

}  // namespace smore
