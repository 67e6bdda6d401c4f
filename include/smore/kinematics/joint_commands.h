// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/joint_trajectory.h"
#include "smore/common/result.h"
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
  virtual Result<JointTrajectory> along(const std::vector<double>& now, const Path& path) const = 0;
};

/// The joint commands of the scenario's robot.
std::unique_ptr<JointCommands> makeJointCommands(const Scenario& scenario);

}  // namespace smore
