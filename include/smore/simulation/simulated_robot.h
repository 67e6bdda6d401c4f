// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "smore/common/joint_trajectory.h"
#include "smore/common/result.h"
#include "smore/contact/contact_observation.h"
#include "smore/contact/payload.h"
#include "smore/kinematics/urdf_model.h"
#include "smore/scenario/scenario.h"
#include "smore/simulation/wrench_sensor.h"

namespace smore {

/// The object's name as a body in contact; other bodies are links of the robot.
constexpr char kObjectBody[] = "object";

/// One point of contact between what the wrist sensor carries and the environment, as the physics
/// engine knows it. For tests and scores only; nothing that maps or plans may see it.
struct ContactPoint {
  Vec3 position = Vec3::Zero();  ///< in the world [m]
  Vec3 force = Vec3::Zero();     ///< on the carried body, in the world [N], normal and friction
  std::string body;              ///< kObjectBody or the link of the gripper that is touched
};

/// A gripper's fingers.
struct GripperState {
  std::string joint;      ///< of the fingers in the robot's description
  double position = 0.0;  ///< [rad], 0 for open
  bool moving = false;
  bool holds_object = false;
};

/// A robot in a simulated scene, stepped by hand: time passes only in `advance`. Everything that it
/// does follows from the scenario and the seed.
class SimulatedRobot {
 public:
  virtual ~SimulatedRobot() = default;

  /// Replaces the commanded motion: straight to the first pose, then along `path` at the scenario's
  /// speed. Empty: stay here. Gives the reason where the robot cannot do it: it stays where it is.
  /// InputError for a pose that is not finite; the motion goes on as it was.
  virtual std::optional<Failure> follow(const Path& path) = 0;

  /// The same along a way that the robot has come: only reach and its joints' own limits can keep
  /// it from that.
  virtual std::optional<Failure> goBack(const Path& path) = 0;

  /// T_world_object of the first place on the last path where the robot cannot be; nothing where it
  /// can follow it.
  virtual std::optional<Pose> refusedAt() const = 0;

  /// Replaces the commanded motion by one of the joints, which starts now. No points: stay here.
  /// Gives the reason where the robot cannot do it: it stays where it is. InputError for unknown
  /// joints, values that are not finite or times that do not rise; the motion goes on as it was.
  virtual std::optional<Failure> followJoints(const JointTrajectory& trajectory) = 0;

  /// Ends the commanded motion at the present pose, at once.
  virtual void stop() = 0;

  /// Sets the robot to a pose, at rest, in no time. InputError for a pose that is not finite or out
  /// of reach.
  virtual void place(const Pose& T_world_object) = 0;

  /// Whether `place` stands for something that this robot can do: an arm moves back along its way.
  virtual bool canBePlaced() const = 0;

  /// Whether a commanded motion has not reached its end.
  virtual bool moving() const = 0;

  /// Why the robot has ended its motion by itself: a link has touched something, a joint does not
  /// follow. Nothing from the next command on.
  virtual std::optional<Failure> fault() const = 0;

  /// Advances one sensor period (2 ms: 500 Hz, as the UR5e's sensor) and reads the wrist: the raw
  /// wrench with the sensor's noise and bias, and the pose that the joints say.
  virtual WrenchSample advance() = 0;

  /// Nothing for a robot without a gripper: it holds the object for ever.
  virtual std::optional<GripperState> gripper() const = 0;

  /// Starts to move the fingers to a position [rad], 0 for open, within their limits. They stop at
  /// an object between them and hold it; opened, they let it go. Gives the reason where that cannot
  /// be: no gripper, or an arm in motion.
  virtual std::optional<Failure> moveGripper(double position) = 0;

  /// The reading behind the last sample.
  virtual WristReading reading() const = 0;

  /// Pose of the object frame in the sensor's frame.
  virtual Pose T_sensor_object() const = 0;

  /// Simulated time [s].
  virtual double time() const = 0;

  /// What the wrist carries while it holds the object, as somebody who has weighed it would state
  /// it; no mass where the wrist does not feel it.
  virtual Payload payload() const = 0;

  /// T_world_object by the joints: of the object as it was held at the start.
  virtual Pose pose() const = 0;

  virtual std::vector<std::string> jointNames() const = 0;
  /// [rad] or [m], in the order of the names.
  virtual std::vector<double> jointPositions() const = 0;
  /// [rad/s] or [m/s], in the order of the names; empty where they are not known.
  virtual std::vector<double> jointVelocities() const = 0;

  /// The true contacts of the last step.
  virtual std::vector<ContactPoint> contacts() const = 0;
};

/// The robot of the scenario in its scene (no perturbation is added here), with `sensor_cutoff` of
/// the wrist sensor's low-pass [Hz], infinite for none. InputError where start or goal touch the
/// environment, with the remedy.
std::unique_ptr<SimulatedRobot> makeSimulatedRobot(const Scenario& scenario, std::uint64_t seed,
                                                   double sensor_cutoff = kNoLowPass);

/// The same with an arm of one's own in the place of the UR5e: any URDF of six joints whose frames
/// have the names of Universal Robots' driver, and a `grasp_frame`. InputError where it is not
/// such.
std::unique_ptr<SimulatedRobot> makeSimulatedArm(const Scenario& scenario, const UrdfModel& urdf,
                                                 std::uint64_t seed,
                                                 double sensor_cutoff = kNoLowPass);

/// The scenario of one trial: environment and grasp perturbed as `scenario.perturb` says, drawn
/// from `seed` and again until start and goal are free of contact. InputError where 1000 draws did
/// not do.
Scenario perturbScenario(const Scenario& scenario, std::uint64_t seed);

}  // namespace smore
