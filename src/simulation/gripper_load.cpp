// SPDX-License-Identifier: BSD-3-Clause
#include "gripper_load.h"

#include <algorithm>

namespace smore {
namespace {

// The pads' rubber follows the object for about a millimetre.
constexpr double kRelease = 0.02;                 // of a turning finger [rad]
constexpr double kReleaseOfSlidingFinger = 1e-3;  // [m]

}  // namespace

GripperLoad::GripperLoad(const Scenario& scenario, const UrdfModel& urdf, const ArmFrames& frames,
                         const Pose& T_tool_object, const Pose& T_world_tool, double step)
    : scenario_(scenario),
      urdf_(urdf),
      frames_(frames),
      step_(step),
      T_tool_object_at_start_(T_tool_object),
      T_tool_object_(T_tool_object) {
  const KinematicTree gripper(urdf, frames.tool);
  if (const auto finger = describedFinger(urdf, gripper)) {
    finger_joint_ = finger->name;
    finger_speed_ = finger->limits->velocity;
    finger_limit_ = finger->limits->upper;
    release_ = finger->type == urdf::Joint::PRISMATIC ? kReleaseOfSlidingFinger : kRelease;
  }
  place(T_world_tool);
}

void GripperLoad::place(const Pose& T_world_tool) {
  const auto grasp = graspAngle(scenario_, urdf_, frames_, T_tool_object_at_start_);
  if (!grasp) {
    throw InputError("scenario " + scenario_.name + ": gripper_object: " + grasp.reason() +
                     "; change gripper_object or the object's shapes");
  }
  finger_ = target_ = *grasp;
  hold(T_tool_object_at_start_, T_world_tool);
}

void GripperLoad::hold(const Pose& T_tool_object, const Pose& T_world_tool) {
  T_tool_object_ = T_tool_object;
  grasp_ = finger_;
  will_hold_ = false;
  free_object_.reset();
  replaceBody(
      withObject(gripperBody(urdf_, frames_, finger_), objectBody(scenario_), T_tool_object),
      T_world_tool);
}

void GripperLoad::letGo(const Pose& T_world_tool) {
  free_object_ = std::make_unique<BulletWorld>(scenario_, objectBody(scenario_), gravity(), step_);
  free_object_->place(T_world_tool * T_tool_object_);
  replaceBody(gripperBody(urdf_, frames_, finger_), T_world_tool);
}

void GripperLoad::replaceBody(CarriedBody body, const Pose& T_world_tool) {
  body_ = std::move(body);
  ++version_;
  held_ = std::make_unique<HeldBody>(scenario_, body_, T_world_tool, HeldBody::Feel::kEverything,
                                     step_);
}

void GripperLoad::moveFingers(double target, const Pose& T_world_tool) {
  target_ = std::clamp(target, 0.0, finger_limit_);
  will_hold_ = false;
  if (holdsObject()) {
    target_ = std::min(target_, grasp_);
    return;
  }
  const auto grasp =
      graspAngle(scenario_, urdf_, frames_, T_world_tool.inverse() * objectPose(T_world_tool));
  if (!grasp || finger_ > *grasp || target_ < *grasp) return;
  target_ = *grasp;
  will_hold_ = true;
}

Pose GripperLoad::objectPose(const Pose& T_world_tool) const {
  return free_object_ ? free_object_->motion().T_world_object : T_world_tool * T_tool_object_;
}

void GripperLoad::advance(const Pose& T_world_tool_before, const Pose& T_world_tool_after) {
  held_->advance(T_world_tool_before, T_world_tool_after);
  if (free_object_) free_object_->step({});
  if (!fingersMove()) return;
  const double way = finger_speed_ * step_;
  finger_ += std::clamp(target_ - finger_, -way, way);
  if (holdsObject() && finger_ < grasp_ - release_) letGo(T_world_tool_after);
  if (fingersMove()) return;
  if (will_hold_) {
    hold(T_world_tool_after.inverse() * objectPose(T_world_tool_after), T_world_tool_after);
  } else if (!holdsObject()) {
    replaceBody(gripperBody(urdf_, frames_, finger_), T_world_tool_after);
  }
}

}  // namespace smore
