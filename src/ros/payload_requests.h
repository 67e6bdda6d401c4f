// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/contact/contact_sensing.h"
#include "smore/contact/payload_identification.h"
#include "smore/contact/still_poses.h"
#include "smore/contact/wrench_axes.h"
#include "smore/ros/sensing_request.h"

namespace smore {

/// What services ask of the payload, done between two samples: that it be identified from the poses
/// at which the robot stood still, and that what was identified be forgotten, as something else is
/// held. A tare begins with either, since the bias was that of another payload.
class PayloadRequests {
 public:
  /// `told`: the payload by the parameters; `axes` are the sensor's present ones.
  PayloadRequests(const Payload& told, const WrenchAxes& axes) : told_(told), axes_(axes) {}

  /// For the threads that ask; each waits for its answer.
  SensingRequest& identification() { return identification_; }
  SensingRequest& forgetting() { return forgetting_; }

  /// Does what was asked for, before a sample is processed; whether the payload is another one now.
  /// Refused as `identifyPayload`, `ContactSensing::payloadObjection` and `graspObjection` have it:
  /// a weight that feels like a contact is no reason not to forget what it was.
  bool apply(ContactSensing* sensing);

  /// Learns where the robot stands from a sample that was processed.
  void add(const WrenchSample& sample, ContactState state, const ContactSensing& sensing);

  /// What was averaged so far is of another bias.
  void forgetPoses() { still_poses_.clear(); }

  /// Answers what waits for the tare that has come to its end.
  void finish();

 private:
  bool identify(ContactSensing* sensing);
  bool forget(ContactSensing* sensing);

  Payload told_;
  WrenchAxes axes_;
  StillPoses still_poses_;
  std::string found_;  ///< what was identified last; empty: nothing yet
  SensingRequest identification_, forgetting_;
};

}  // namespace smore
