// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "smore/common/robot.h"
#include "smore/common/trail.h"
#include "smore/contact/contact_sensing.h"
#include "smore/scenario/scenario.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

/// InputError where a robot that has begun to advance has a fault already (a link that touches, a
/// joint that does not hold itself): such a one would end no motion later.
void requireNoFaultAtStart(const SimulatedRobot& robot);

/// The contact sensing of a scenario's trials: its thresholds, the noise that it declares, and the
/// weight of what an arm carries where its motions tilt that.
ContactSensingParameters sensingParameters(const Scenario& scenario, const SimulatedRobot& robot);

/// Wall time spent in the parts of the loop [s].
struct LoopTimes {
  double simulation = 0.0;
  double sensing_and_mapping = 0.0;
};

/// The simulated robot with its contact sensing in one process: each sensor sample is processed
/// before the next one is made, so that nothing depends on timing.
class InProcessRobot : public Robot {
 public:
  using ObservationCallback = std::function<void(const ContactObservation&)>;

  /// Tares at the present pose; std::runtime_error if the sensor does not settle. `robot` must
  /// outlive this. `on_observation` gets each observation made while the robot moves and while a
  /// contact is measured.
  InProcessRobot(SimulatedRobot* robot, const ContactSensingParameters& sensing, std::uint64_t seed,
                 ObservationCallback on_observation);

  Pose pose() const override { return robot_->pose(); }
  MotionResult follow(const Path& path) override;
  MotionResult retreat(double distance) override;
  MotionResult reset(const Pose& start) override;

  /// The last sample's wrench without the sensor's bias, at the origin and in the axes of the
  /// object frame.
  const Wrench& wrench() const { return sensing_.compensated(); }

  const LoopTimes& times() const { return times_; }

 private:
  /// A stretch of a retreat.
  MotionResult goBack(const Path& back);
  /// One sensor period; the observation has been handed on if `report`.
  ContactObservation advance(bool report);
  /// Stands still until the line of the present contact has been given, or contact is lost.
  void settleInContact(ContactObservation observation);
  /// Stands still until the sensor says free; false if it does not within a deadline.
  bool waitUntilFree();

  SimulatedRobot* robot_;
  ContactSensing sensing_;
  ObservationCallback on_observation_;
  LoopTimes times_;
  Trail trail_;  ///< since the last reset
};

}  // namespace smore
