// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "smore/common/robot.h"
#include "smore/experiment/in_process_robot.h"
#include "smore/mapping/twin_map.h"
#include "smore/retrieval/method.h"
#include "smore/scenario/scenario.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {

/// Largest magnitude of an action, on each axis (paper, section IV-A).
constexpr double kLargestShift = 0.03;  // [m]
constexpr double kLargestTurn = 0.3;    // [rad]

/// What one action led to.
struct StepOutcome {
  MotionEnd end = MotionEnd::kReached;
  std::string reason;                      ///< of kUnreachable and kFault, in words for the user
  Pose T_world_object = Pose::Identity();  ///< where the motion ended, before the object went back
  /// There, without the sensor's bias, at the origin and in the axes of the object frame; after a
  /// contact when the wrench stands still.
  Wrench wrench;
  bool at_goal = false;  ///< the motion ended within the scenario's tolerance, without a contact
};

/// One trial of smore_experiment whose motions are given from outside, one small action at a time,
/// instead of by a planner: the same scene, robot and contact sensing from the same seed.
///
/// Planar: actions and differences are (x, y, yaw) in the axes of the start pose. Spatial: (x, y,
/// z) and a rotation vector, in the axes of the world.
class SteppedTrial {
 public:
  /// `maps`: the method whose twin maps learn from all that is observed; nothing: none do.
  /// InputError for a task without a scene, or a method that keeps no maps or cannot use the
  /// scenario's prior knowledge; std::runtime_error if the sensor cannot be tared at the start.
  SteppedTrial(const Scenario& scenario, std::uint64_t seed, std::optional<MethodKind> maps = {});

  SteppedTrial(const SteppedTrial&) = delete;
  SteppedTrial& operator=(const SteppedTrial&) = delete;

  /// Numbers of an action: 3 or 6.
  int dimensions() const { return planar() ? 3 : 6; }

  /// Moves straight by `action` [m, rad] at the scenario's speed, each number clipped to the
  /// largest magnitude, no further than to the workspace's border. A contact stops the object; it
  /// then goes back as the scenario says (`on_contact`): to the start, or some way. InputError for
  /// a wrong count of numbers or one that is not finite, and nothing moves; std::runtime_error
  /// where an arm cannot go back.
  StepOutcome step(const Eigen::VectorXd& action);

  /// Back to the start; the scene, what the maps know and the sensor's noise go on. Throws
  /// std::runtime_error where the robot cannot be placed there.
  void restart();

  /// From the object's pose to the goal [m, rad]; angles in [-pi, pi].
  Eigen::VectorXd difference() const;

  /// T_world_object now.
  Pose pose() const { return robot_->pose(); }

  /// The axes that actions are given in, as they stand at the start pose (planar) or the origin.
  Pose T_world_axes() const { return planar() ? scene_.start : Pose::Identity(); }

  /// Contacts so far, restarts included.
  int collisions() const { return collisions_; }

  /// Simulated time [s].
  double time() const { return simulated_->time(); }

  /// The scenario with this trial's perturbation.
  const Scenario& scene() const { return scene_; }

  /// The twin maps, worked out. InputError where none are kept.
  const TwinMap& maps() const;

 private:
  bool planar() const { return scene_.motion == Motion::kPlanar; }
  Pose target(const Eigen::VectorXd& action) const;
  void goBack();

  Scenario scene_;
  std::unique_ptr<SimulatedRobot> simulated_;
  std::unique_ptr<TwinMap> maps_;
  std::unique_ptr<InProcessRobot> robot_;
  int collisions_ = 0;
};

}  // namespace smore
