// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "held_body.h"
#include "smore/simulation/hand_motion.h"
#include "smore/simulation/simulated_robot.h"
#include "smore/simulation/wrench_sensor.h"

namespace smore {

/// The paper's virtual robot: three prismatic and three revolute joints that set the hand's pose
/// directly (identity Jacobian). The hand follows its commands exactly; the object hangs on it by
/// the wrist's spring, whose wrench is what the sensor reads. To the sensor the object has no
/// weight, and while it touches nothing no inertia either: it moves with the hand
/// (docs/simulation.md).
class CartesianRobot : public SimulatedRobot {
 public:
  CartesianRobot(const Scenario& scenario, std::uint64_t seed, double sensor_cutoff);

  std::optional<Failure> follow(const Path& path) override;
  std::optional<Failure> goBack(const Path& path) override { return follow(path); }
  std::optional<Pose> refusedAt() const override { return std::nullopt; }
  std::optional<Failure> followJoints(const JointTrajectory& trajectory) override;
  void stop() override { hand_.stop(); }
  void place(const Pose& T_world_object) override;
  bool canBePlaced() const override { return true; }
  bool moving() const override { return hand_.moving(); }
  std::optional<Failure> fault() const override { return std::nullopt; }
  WrenchSample advance() override;
  std::optional<GripperState> gripper() const override { return std::nullopt; }
  std::optional<Failure> moveGripper(double position) override;
  WristReading reading() const override { return reading_; }
  Pose T_sensor_object() const override { return Pose::Identity(); }
  Payload payload() const override { return {}; }
  double time() const override;
  Pose pose() const override { return hand_.pose(); }
  std::vector<std::string> jointNames() const override;
  std::vector<double> jointPositions() const override;
  std::vector<double> jointVelocities() const override { return {}; }
  std::vector<ContactPoint> contacts() const override { return object_.contacts(); }

 private:
  void advanceSubstep();

  HandMotion hand_;
  HeldBody object_;
  WrenchSensor sensor_;
  WristReading reading_;
  std::int64_t substeps_ = 0;
};

}  // namespace smore
