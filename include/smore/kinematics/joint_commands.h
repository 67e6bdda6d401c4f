// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/joint_trajectory.h"
#include "smore/common/result.h"
#include "smore/kinematics/tool_gap.h"
#include "smore/kinematics/urdf_model.h"
#include "smore/kinematics/way.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// Turns ways of the object into motions of the joints of the robot that holds it.
class JointCommands {
 public:
  virtual ~JointCommands() = default;

  /// The robot's joints, in the order in which their positions are given here.
  virtual std::vector<std::string> jointNames() const = 0;

  /// The motion from the joint positions `now` along `path` (T_world_object), at the scenario's
  /// speed; the reason where the robot cannot do all of it. No points where it is at the end of the
  /// path already.
  ///
  /// At `now` the object is seen at `seen` (T_world_object). What it is off there from where joints
  /// and description have it is taken to stay the same in the object's axes, so that the object is
  /// seen along the path, and the motion begins without a jump. `refused_at`, unless null, receives
  /// where on the path it is seen at the first pose that the robot cannot reach.
  virtual Result<JointTrajectory> along(const std::vector<double>& now, const Pose& seen,
                                        const Path& path, Way way,
                                        Pose* refused_at = nullptr) const = 0;

  /// How far the tool is seen, by the object's pose `seen` (T_world_object), from where joints and
  /// description have it, in the axes of the tool: identity where both agree. Nothing for a robot
  /// without description.
  virtual std::optional<Pose> toolGap(const std::vector<double>& now, const Pose& seen) const = 0;

  /// How large that gap may be: less where the description carries the arm's calibration
  /// (isCalibrated).
  virtual ToolGapLimits toolGapLimits() const { return kNominalToolGap; }

  /// Where the arm's description comes from (UrdfModel::source); empty for a robot without.
  virtual std::string descriptionSource() const { return ""; }
};

/// The joint commands of the scenario's robot; an arm is the maker's nominal one.
std::unique_ptr<JointCommands> makeJointCommands(const Scenario& scenario);

/// The same for the scenario's arm by this description, which has the frames of ArmFrames.
std::unique_ptr<JointCommands> makeJointCommands(const Scenario& scenario, const UrdfModel& arm);

}  // namespace smore
