// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/scenario/motion_space.h"
#include "smore/scenario/prior_source.h"
#include "smore/scenario/shape.h"

namespace smore {

enum class Task { kRetrieve, kReconstruct };
/// kUrdf: an arm of another make, by its description.
enum class RobotKind { kCartesian, kUr3e, kUr5e, kUr10e, kUr16e, kUrdf };
enum class OnContact { kReset, kRetreat };

/// Names of the robots in records, in the order of RobotKind.
const std::vector<std::string>& robotNames();

/// The name of one.
const std::string& robotName(RobotKind kind);

/// Whether it is an arm of joints; the Cartesian robot sets its hand's pose directly.
bool isArm(RobotKind kind);

/// Errors of the simulated wrist sensor, per axis.
struct WrenchNoise {
  double force_stddev = 0.0;        ///< [N]
  double torque_stddev = 0.0;       ///< [N m]
  Vec3 force_bias = Vec3::Zero();   ///< [N]
  Vec3 torque_bias = Vec3::Zero();  ///< [N m]
  double force_drift = 0.0;         ///< random walk [N per square root of a second]
};

/// Errors added to each line of action, as standard deviations per axis.
struct LineNoise {
  double direction = 0.0;  ///< [rad]
  double offset = 0.0;     ///< [m]
};

/// Per-trial changes of the scene, uniform in plus and minus these.
struct Perturbation {
  double position = 0.0;  ///< shift of the environment on each axis of the motion [m]
  double angle = 0.0;     ///< turn of the object in the hand about its origin [rad]
};

/// A scene and a task, as a scenario file describes them (docs/scenarios.md), or a task alone: a
/// real robot's object and environment are unknown. SI units, radians.
struct Scenario {
  std::string name;
  Task task = Task::kRetrieve;
  double voxel_size = 0.03;  ///< [m]
  Motion motion = Motion::kPlanar;
  RobotKind robot = RobotKind::kCartesian;
  std::string robot_urdf;                 ///< of kUrdf: path of its description
  std::vector<Shape> object;              ///< poses in the object frame; empty: a task
  std::vector<Shape> environment;         ///< poses in the world frame
  Pose start = Pose::Identity();          ///< T_world_object
  Pose goal = Pose::Identity();           ///< T_world_object
  double goal_position_tolerance = 0.02;  ///< [m]
  double goal_angle_tolerance = 0.1;      ///< [rad]
  Bounds workspace;                       ///< of the object frame's origin in the world [m]
  double friction = 0.3;                  ///< Coulomb coefficient of the contact pair
  double linear_speed = 0.1;              ///< of the object frame [m/s]
  double angular_speed = 0.5;             ///< of the object frame [rad/s]
  double contact_force = 5.0;             ///< filtered force at or above: contact [N]
  double free_force = 0.5;                ///< filtered force below: free space [N]
  WrenchNoise wrench_noise;
  LineNoise line_noise;
  OnContact on_contact = OnContact::kReset;
  int reconstruct_touches = 300;
  Perturbation perturb;
  double object_mass = 0.5;                  ///< [kg]
  Pose T_world_base = Pose::Identity();      ///< of an arm: base_link
  Pose T_gripper_object = Pose::Identity();  ///< of an arm: object frame in the grasp frame
  PriorSources prior;                        ///< what is known beforehand

  /// False for a task alone. An object with nothing around it is a scene: there is nothing to
  /// touch.
  bool hasScene() const { return !object.empty(); }

  MotionSpace motionSpace() const { return {motion, start, workspace, !isArm(robot)}; }
};

/// Distance of the farthest point of the object from its origin, at most [m].
double reachOf(const std::vector<Shape>& object);

/// The files that a scenario read or will read: meshes, what is known beforehand, an arm's
/// description.
std::vector<std::string> filesOf(const Scenario& scenario);

/// Where the object may touch anything, in the world [m]: the workspace, wider by the object's
/// reach.
Bounds regionOfContacts(const Scenario& scenario);

/// InputError where the scenario is a task alone, which nobody can simulate.
void requireScene(const Scenario& scenario);

/// The robot as a scenario file names it: by its name, or the path of its description.
const std::string& robotText(const Scenario& scenario);

/// InputError where the robot is no arm.
void requireArm(const Scenario& scenario);

/// Whether the robot turns what its sensor carries against gravity, so that its weight must be
/// known: an arm's motions in space. What moves in the plane is tared, and the simulated Cartesian
/// robot carries nothing.
bool tiltsPayload(const Scenario& scenario);

/// Reads a scenario or a task: a file without `object` and `environment`. InputError with every
/// problem, one a line (file, key, remedy): unreadable or malformed files, unknown or missing keys,
/// impossible values, start or goal outside of the workspace, a workspace beyond the octrees' keys.
/// Whether start and goal are free of contact is checked by the simulation, which knows the shapes'
/// geometry.
Scenario loadScenario(const std::string& file);

}  // namespace smore
