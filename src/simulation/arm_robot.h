// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>

#include "arm_world.h"
#include "gripper_load.h"
#include "smore/kinematics/arm_motion.h"
#include "smore/simulation/joint_motion.h"
#include "smore/simulation/simulated_robot.h"
#include "smore/simulation/wrench_sensor.h"

namespace smore {

/// An arm with motors in its joints, a force/torque sensor in its wrist and a gripper that holds
/// the object (docs/simulation.md).
///
/// The arm up to the sensor is a multi-body. What the sensor carries is one rigid body with weight
/// that hangs on the flange by the wrist's spring: the sensor reads the spring's wrench, and the
/// flange feels its reaction one step later.
class ArmRobot : public SimulatedRobot {
 public:
  ArmRobot(const Scenario& scenario, const UrdfModel& urdf, std::uint64_t seed,
           double sensor_cutoff);

  std::optional<Failure> follow(const Path& path) override { return go(path, Way::kNew); }
  std::optional<Failure> goBack(const Path& path) override { return go(path, Way::kBack); }
  std::optional<Pose> refusedAt() const override { return refused_at_; }
  std::optional<Failure> followJoints(const JointTrajectory& trajectory) override;
  void stop() override;
  void place(const Pose& T_world_object) override;
  bool canBePlaced() const override { return false; }
  bool moving() const override { return joints_.moving(); }
  std::optional<Failure> fault() const override { return fault_; }
  WrenchSample advance() override;
  std::optional<GripperState> gripper() const override;
  std::optional<Failure> moveGripper(double position) override;
  WristReading reading() const override { return reading_; }
  Pose T_sensor_object() const override { return motion_.T_tool_object(); }
  Payload payload() const override;
  double time() const override;
  Pose pose() const override;
  std::vector<std::string> jointNames() const override { return arm_.arm().jointNames(); }
  std::vector<double> jointPositions() const override { return arm_.arm().positions(); }
  std::vector<double> jointVelocities() const override { return arm_.arm().velocities(); }
  std::vector<ContactPoint> contacts() const override { return load_.contacts(); }

 private:
  std::optional<Failure> go(const Path& path, Way way);
  std::optional<Failure> checkLimits(const JointTrajectory& trajectory) const;
  void advanceSubstep();
  void showLoad();
  void watch();
  void stopWith(const std::string& reason);

  ArmMotion motion_;
  GripperLoad load_;
  ArmWorld arm_;
  int load_version_ = 0;
  JointMotion joints_;
  WrenchSensor sensor_;
  WristReading reading_;
  std::optional<Pose> refused_at_;
  std::optional<Failure> fault_;
  std::set<LinkContact> link_contacts_;  ///< in the last step
  std::int64_t substeps_ = 0;
};

}  // namespace smore
