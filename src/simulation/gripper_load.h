// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "carried_load.h"
#include "held_body.h"
#include "smore/common/result.h"

namespace smore {

/// What hangs on the flange beyond the wrist sensor: the gripper, and the object while the fingers
/// hold it.
///
/// The fingers move at their joint's greatest speed and stop at the object's width. Closed on it
/// they hold it as if welded: it neither slips nor gives way. Opened by more than a little they let
/// it go; it then falls and lies as a body of its own, which the gripper does not touch until it
/// closes on it.
class GripperLoad {
 public:
  /// `T_tool_object`: where the scenario's start has the object in the gripper. `step` [s],
  /// positive. InputError where the gripper cannot hold it there.
  GripperLoad(const Scenario& scenario, const UrdfModel& urdf, const ArmFrames& frames,
              const Pose& T_tool_object, const Pose& T_world_tool, double step);

  /// Sets the load to where it hangs at rest, the object in the gripper as at the start.
  void place(const Pose& T_world_tool);

  /// Starts to move the fingers to a joint position [rad], 0 for open, within the joint's limits.
  /// Closing, they stop at the object if it is between them.
  void moveFingers(double target, const Pose& T_world_tool);

  bool fingersMove() const { return finger_ != target_; }

  /// Finger joint: its name (empty without fingers) and position [rad].
  const std::string& fingerJoint() const { return finger_joint_; }
  double fingerPosition() const { return finger_; }

  bool holdsObject() const { return free_object_ == nullptr; }

  /// Advances one step, during which the flange moves between two poses.
  void advance(const Pose& T_world_tool_before, const Pose& T_world_tool_after);

  /// All that the sensor carries, in its frame; `version` rises with each change.
  const CarriedBody& body() const { return body_; }
  int version() const { return version_; }

  /// T_world_object of the object that the gripper has let go, or as the flange would hold it.
  Pose objectPose(const Pose& T_world_tool) const;

  Wrench environmentWrench(const Pose& T_world_tool) const {
    return held_->environmentWrench(T_world_tool);
  }
  std::vector<ContactPoint> contacts() const { return held_->contacts(); }

 private:
  void hold(const Pose& T_tool_object, const Pose& T_world_tool);
  void letGo(const Pose& T_world_tool);
  void replaceBody(CarriedBody body, const Pose& T_world_tool);

  Scenario scenario_;
  UrdfModel urdf_;
  ArmFrames frames_;
  double step_;
  Pose T_tool_object_at_start_;
  Pose T_tool_object_;  ///< of the held object
  std::string finger_joint_;
  double finger_speed_ = 0.0;  ///< [rad/s]
  double finger_limit_ = 0.0;  ///< closed [rad]
  double release_ = 0.0;       ///< opened by so much the fingers let go [rad, of sliding ones m]
  double grasp_ = 0.0;         ///< finger position on the held object [rad]
  double finger_ = 0.0;
  double target_ = 0.0;
  bool will_hold_ = false;  ///< the fingers are on their way to the object
  CarriedBody body_;
  int version_ = 0;
  std::unique_ptr<HeldBody> held_;
  std::unique_ptr<BulletWorld> free_object_;  ///< the object when nothing holds it
};

}  // namespace smore
