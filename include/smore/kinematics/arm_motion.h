// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "smore/common/joint_trajectory.h"
#include "smore/common/result.h"
#include "smore/kinematics/arm_collision.h"
#include "smore/kinematics/arm_model.h"
#include "smore/kinematics/inverse_kinematics.h"
#include "smore/kinematics/way.h"
#include "smore/scenario/scenario.h"

namespace smore {

struct ArmMotionParameters {
  ArmFrames frames;
  Pose T_world_base = Pose::Identity();
  Pose T_grasp_object = Pose::Identity();  ///< object frame in the gripper's grasp frame
  double linear_speed = 0.05;              ///< of the object frame's origin, at most [m/s]
  double angular_speed = 0.25;             ///< of the object, at most [rad/s]
  double joint_acceleration = 1.4;         ///< of each joint, at most [rad/s^2]: 80 deg/s^2
  double limit_margin = 0.05;              ///< kept from each joint's limits [rad]
  /// Smallest singular value of the Jacobian that a motion may pass ([m/s], [rad/s] per rad/s): at
  /// 0.05 the tool's 0.1 m/s ask at most 2 rad/s of a joint. Of an arm that is shorter than a UR5e
  /// it is less in proportion, as its tool moves less with each joint.
  double least_singular_value = 0.05;
  /// Poses of the object that a start configuration should be able to move to on a straight way.
  std::vector<Pose> wanted;
};

/// The parameters that a scenario fixes; wanted are its goal and the corners of its workspace, at
/// the start's orientation.
ArmMotionParameters armMotionParameters(const Scenario& scenario);

/// Motions of an arm that carry the object along given poses. It knows the arm, not the scene: the
/// scene is what touch has yet to tell.
class ArmMotion {
 public:
  /// InputError where the URDF does not describe an arm of six joints with these frames.
  ArmMotion(const UrdfModel& urdf, const ArmMotionParameters& parameters);

  const ArmModel& model() const { return arm_; }

  /// Object frame in the tool frame (the wrist sensor's).
  const Pose& T_tool_object() const { return T_tool_object_; }

  /// T_world_tool.
  Pose toolPose(const JointVector& q) const;

  /// T_world_object.
  Pose objectPose(const JointVector& q) const;

  /// A configuration that holds the object at a pose: within limits, free of self-collision; of
  /// those the one from which most of the wanted poses are reachable, then above the mounting plane
  /// of its base, then farthest from singularities and limits on the way to them. The reason where
  /// there is none.
  Result<JointVector> configurationFor(const Pose& T_world_object) const;

  /// The motion of the joints from `now` along `path` (T_world_object): straight to the first pose,
  /// then from pose to pose, each position on a straight line and each turn about one axis,
  /// resolved every 5 mm and 0.02 rad on the branch of `now`. It keeps within the speeds of object
  /// and joints, starts and ends at rest, and does not stop at poses where the path bends little.
  /// The whole of it is checked: the reason names the first pose that is out of reach, near a
  /// singularity or a limit, or where links would collide; a joint that stands nearer to a limit
  /// than the margin may move away from it. Of a way back only reach and the limits themselves are
  /// checked. No points where `now` is at the end of the path already. InputError for poses that
  /// are not finite. `refused_at`, unless null, receives T_world_object of the pose that is named.
  Result<JointTrajectory> trajectory(const JointVector& now, const Path& path, Way way = Way::kNew,
                                     Pose* refused_at = nullptr) const;

 private:
  /// By the branch of `now`, without asking whether the arm may be there.
  Result<JointVector> next(const JointVector& now, const Pose& T_world_object) const;
  /// `start`: where the motion began; null for a configuration that none leads to.
  Result<bool> checkLimits(const JointVector& q, double margin, const JointVector* start) const;
  Result<bool> checkConfiguration(const JointVector& q, const JointVector* start = nullptr) const;
  Result<std::vector<JointVector>> resolve(const JointVector& now, const Path& path, Way way,
                                           Pose* refused_at = nullptr) const;
  JointVector nearestTurns(const JointVector& q) const;
  /// Smallest singular value times a factor for each joint that is 1 in the middle of its range and
  /// 0 at its limits.
  double margin(const JointVector& q) const;
  Pose T_base_tool(const Pose& T_world_object) const;
  JointTrajectory timed(const std::vector<JointVector>& configurations) const;

  struct Score;
  Score score(const JointVector& q) const;

  ArmMotionParameters parameters_;
  ArmModel arm_;
  double least_singular_value_;  ///< of this arm
  InverseKinematics inverse_kinematics_;
  ArmCollision collision_;
  Pose T_tool_object_;
};

}  // namespace smore
