// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bullet_world.h"
#include "smore/common/result.h"
#include "smore/kinematics/arm_model.h"
#include "smore/kinematics/kinematic_tree.h"

namespace smore {

/// The joint that opens and closes a gripper, with its limits; null for an arm without fingers.
/// InputError where the description tells no limits of it, or has more than one such joint.
urdf::JointConstSharedPtr describedFinger(const UrdfModel& urdf, const KinematicTree& gripper);

/// Finger angle [rad] at which the gripper's fingers, closing from open, are about to touch the
/// scenario's object at a pose in the tool frame; 0 for an arm without fingers. The reason where
/// they touch it when open, or do not meet it.
Result<double> graspAngle(const Scenario& scenario, const UrdfModel& urdf, const ArmFrames& frames,
                          const Pose& T_tool_object);

/// What the URDF has beyond the wrist sensor, the fingers at an angle [rad], as one rigid body in
/// the sensor's frame.
CarriedBody gripperBody(const UrdfModel& urdf, const ArmFrames& frames, double finger_angle);

/// The gripper and an object that it holds rigidly, as one body in the sensor's frame.
CarriedBody withObject(CarriedBody gripper, const CarriedBody& object, const Pose& T_tool_object);

}  // namespace smore
