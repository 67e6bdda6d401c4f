// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "smore/contact/contact_observation.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// One point of contact between the object and the environment, as the physics engine knows it. For
/// tests and scores only; nothing that maps or plans may see it.
struct ContactPoint {
  Vec3 position = Vec3::Zero();  ///< in the world [m]
  Vec3 force = Vec3::Zero();     ///< on the object, in the world [N], normal and friction
};

/// A robot in a simulated scene, stepped by hand: time passes only in `advance`. Everything that it
/// does follows from the scenario and the seed.
class SimulatedRobot {
 public:
  virtual ~SimulatedRobot() = default;

  /// Replaces the commanded motion: straight to the first pose, then along `path` at the scenario's
  /// speed. Empty: stay here. InputError for a pose that is not finite; the motion goes on as it
  /// was.
  virtual void follow(const Path& path) = 0;

  /// Ends the commanded motion at the present pose, at once.
  virtual void stop() = 0;

  /// Sets the robot to a pose, at rest, in no time. InputError for a pose that is not finite.
  virtual void place(const Pose& T_world_object) = 0;

  /// Whether a commanded motion has not reached its end.
  virtual bool moving() const = 0;

  /// Advances one sensor period (2 ms: 500 Hz, as the UR5e's sensor) and reads the wrist: the raw
  /// wrench with the sensor's noise and bias, and the pose that the joints say.
  virtual WrenchSample advance() = 0;

  /// Simulated time [s].
  virtual double time() const = 0;

  /// T_world_object by the joints.
  virtual Pose pose() const = 0;

  virtual std::vector<std::string> jointNames() const = 0;
  /// [rad] or [m], in the order of the names.
  virtual std::vector<double> jointPositions() const = 0;

  /// The true contacts of the last step.
  virtual std::vector<ContactPoint> contacts() const = 0;
};

/// The robot of the scenario in its scene (no perturbation is added here). InputError where start
/// or goal touch the environment, with the remedy.
std::unique_ptr<SimulatedRobot> makeSimulatedRobot(const Scenario& scenario, std::uint64_t seed);

/// The scenario of one trial: environment and grasp perturbed as `scenario.perturb` says, drawn
/// from `seed` and again until start and goal are free of contact. InputError where 1000 draws did
/// not do.
Scenario perturbScenario(const Scenario& scenario, std::uint64_t seed);

}  // namespace smore
