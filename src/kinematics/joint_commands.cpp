// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/joint_commands.h"

#include "smore/kinematics/arm_motion.h"
#include "smore/kinematics/cartesian_joints.h"
#include "smore/kinematics/described_arm.h"

namespace smore {
namespace {

class CartesianCommands : public JointCommands {
 public:
  explicit CartesianCommands(const Scenario& scenario)
      : linear_speed_(scenario.linear_speed), angular_speed_(scenario.angular_speed) {}

  std::vector<std::string> jointNames() const override { return cartesianJointNames(); }

  Result<JointTrajectory> along(const std::vector<double>& /*now*/, const Pose& /*seen*/,
                                const Path& path, Way /*way*/,
                                Pose* /*refused_at*/) const override {
    return cartesianTrajectory(path, linear_speed_, angular_speed_);
  }

  std::optional<Pose> toolGap(const std::vector<double>& /*now*/,
                              const Pose& /*seen*/) const override {
    return std::nullopt;
  }

 private:
  double linear_speed_;
  double angular_speed_;
};

class ArmCommands : public JointCommands {
 public:
  ArmCommands(const Scenario& scenario, const UrdfModel& arm)
      : motion_(arm, armMotionParameters(scenario)),
        limits_(isCalibrated(scenario, arm) ? kCalibratedToolGap : kNominalToolGap),
        source_(arm.source) {}

  std::vector<std::string> jointNames() const override {
    const auto& names = motion_.model().jointNames();
    return {names.begin(), names.end()};
  }

  Result<JointTrajectory> along(const std::vector<double>& now, const Pose& seen, const Path& path,
                                Way way, Pose* refused_at) const override {
    const JointVector q = toJointVector(now);
    const Pose T_seen_described = seen.inverse() * motion_.objectPose(q);
    Path described = path;
    for (Pose& pose : described) pose = pose * T_seen_described;
    auto trajectory = motion_.trajectory(q, described, way, refused_at);
    if (!trajectory && refused_at != nullptr)
      *refused_at = *refused_at * T_seen_described.inverse();
    return trajectory;
  }

  std::optional<Pose> toolGap(const std::vector<double>& now, const Pose& seen) const override {
    const Pose T_world_seen_tool = seen * motion_.T_tool_object().inverse();
    return motion_.toolPose(toJointVector(now)).inverse() * T_world_seen_tool;
  }

  ToolGapLimits toolGapLimits() const override { return limits_; }

  std::string descriptionSource() const override { return source_; }

 private:
  ArmMotion motion_;
  ToolGapLimits limits_;
  std::string source_;
};

}  // namespace

std::unique_ptr<JointCommands> makeJointCommands(const Scenario& scenario) {
  if (isArm(scenario.robot)) return makeJointCommands(scenario, armUrdf(scenario));
  return std::make_unique<CartesianCommands>(scenario);
}

std::unique_ptr<JointCommands> makeJointCommands(const Scenario& scenario, const UrdfModel& arm) {
  return std::make_unique<ArmCommands>(scenario, arm);
}

}  // namespace smore
