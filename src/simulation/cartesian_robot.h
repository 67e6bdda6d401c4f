// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bullet_world.h"
#include "smore/simulation/hand_motion.h"
#include "smore/simulation/simulated_robot.h"
#include "smore/simulation/wrench_sensor.h"
#include "smore/simulation/wrist_spring.h"

namespace smore {

/// The paper's virtual robot: three prismatic and three revolute joints that set the hand's pose
/// directly (identity Jacobian). The hand follows its commands exactly; the object hangs on it by
/// the wrist's spring, whose wrench is what the sensor reads. To the sensor the object has no
/// weight, and while it touches nothing no inertia either: it moves with the hand
/// (docs/simulation.md).
class CartesianRobot : public SimulatedRobot {
 public:
  CartesianRobot(const Scenario& scenario, std::uint64_t seed);

  void follow(const Path& path) override;
  void stop() override { hand_.stop(); }
  void place(const Pose& T_world_object) override;
  bool moving() const override { return hand_.moving(); }
  WrenchSample advance() override;
  double time() const override;
  Pose pose() const override { return hand_.pose(); }
  std::vector<std::string> jointNames() const override;
  std::vector<double> jointPositions() const override;
  std::vector<ContactPoint> contacts() const override { return world_.contacts(); }

 private:
  /// Velocity of a body that moves with the hand, at its centre of mass.
  struct HandVelocity {
    Vec3 linear = Vec3::Zero();   ///< [m/s]
    Vec3 angular = Vec3::Zero();  ///< [rad/s]
  };

  void advanceSubstep();
  HandVelocity moveHand();
  Wrench springWrench(const Pose& T_world_hand, const HandVelocity& hand_velocity) const;

  MassProperties object_;
  HandMotion hand_;
  HandVelocity hand_velocity_;
  BulletWorld world_;
  WristSpring spring_;
  WrenchSensor sensor_;
  Wrench environment_wrench_;  ///< on the object, at its frame's origin, in the axes of the world
  Vec3 wrench_origin_;         ///< where that origin was
  std::int64_t substeps_ = 0;
};

}  // namespace smore
