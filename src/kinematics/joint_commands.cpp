// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/joint_commands.h"

#include "smore/kinematics/arm_motion.h"
#include "smore/kinematics/cartesian_joints.h"

namespace smore {
namespace {

class CartesianCommands : public JointCommands {
 public:
  explicit CartesianCommands(const Scenario& scenario)
      : linear_speed_(scenario.linear_speed), angular_speed_(scenario.angular_speed) {}

  std::vector<std::string> jointNames() const override { return cartesianJointNames(); }

  Result<JointTrajectory> along(const std::vector<double>& /*now*/,
                                const Path& path) const override {
    return cartesianTrajectory(path, linear_speed_, angular_speed_);
  }

 private:
  double linear_speed_;
  double angular_speed_;
};

class ArmCommands : public JointCommands {
 public:
  explicit ArmCommands(const Scenario& scenario)
      : motion_(armUrdf(scenario.robot), armMotionParameters(scenario)) {}

  std::vector<std::string> jointNames() const override {
    const auto& names = motion_.model().jointNames();
    return {names.begin(), names.end()};
  }

  Result<JointTrajectory> along(const std::vector<double>& now, const Path& path) const override {
    return motion_.trajectory(toJointVector(now), path);
  }

 private:
  ArmMotion motion_;
};

}  // namespace

std::unique_ptr<JointCommands> makeJointCommands(const Scenario& scenario) {
  if (isArm(scenario.robot)) return std::make_unique<ArmCommands>(scenario);
  return std::make_unique<CartesianCommands>(scenario);
}

}  // namespace smore
