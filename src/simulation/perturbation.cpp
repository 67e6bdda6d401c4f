// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <random>

#include "carried_load.h"
#include "smore/common/result.h"
#include "smore/kinematics/arm_model.h"
#include "smore/simulation/scene_check.h"
#include "smore/simulation/simulated_robot.h"

namespace smore {
namespace {

constexpr int kMaxDraws = 1000;

using Random = std::mt19937_64;

double uniform(Random* random, double half_width) {
  return std::uniform_real_distribution<double>(-half_width, half_width)(*random);
}

// In the plane of a planar motion, in all directions else; in the world.
Vec3 drawShift(const Scenario& scenario, Random* random) {
  const double half_width = scenario.perturb.position;
  Vec3 shift = Vec3::Zero();
  shift.y() = uniform(random, half_width);
  shift.x() = uniform(random, half_width);
  if (scenario.motion == Motion::kPlanar) return scenario.start.linear() * shift;
  shift.z() = uniform(random, half_width);
  return shift;
}

Vec3 drawAxis(const Scenario& scenario, Random* random) {
  if (scenario.motion == Motion::kPlanar) return Vec3::UnitZ();
  std::normal_distribution<double> normal;
  const Vec3 axis = Vec3::NullaryExpr([&] { return normal(*random); });
  return axis.normalized();
}

Scenario drawPerturbed(const Scenario& scenario, Random* random) {
  Scenario perturbed = scenario;
  const Vec3 shift = drawShift(scenario, random);
  const Vec3 axis = drawAxis(scenario, random);
  const Eigen::AngleAxisd turn(uniform(random, scenario.perturb.angle), axis);
  for (Shape& shape : perturbed.environment) shape.pose.pretranslate(shift);
  for (Shape& shape : perturbed.object) shape.pose = turn * shape.pose;
  return perturbed;
}

/// Whether a gripper can close on the object: a turn about its origin may carry the handle off.
class Grasp {
 public:
  explicit Grasp(const Scenario& scenario) {
    if (!isArm(scenario.robot) || scenario.perturb.angle == 0.0) return;
    urdf_ = armUrdf(scenario);
    T_tool_object_ = ArmModel(*urdf_).T_tool_grasp() * scenario.T_gripper_object;
    if (!holds(scenario)) urdf_.reset();  // not by a turn; the robot says why
  }

  bool holds(const Scenario& perturbed) const {
    return !urdf_ || graspAngle(perturbed, *urdf_, {}, T_tool_object_);
  }

 private:
  std::optional<UrdfModel> urdf_;
  Pose T_tool_object_ = Pose::Identity();
};

}  // namespace

Scenario perturbScenario(const Scenario& scenario, std::uint64_t seed) {
  Random random(seed);
  const Grasp grasp(scenario);
  for (int draw = 0; draw < kMaxDraws; ++draw) {
    Scenario perturbed = drawPerturbed(scenario, &random);
    SceneCheck check(perturbed);
    if (check.touches(perturbed.start) || check.touches(perturbed.goal)) continue;
    if (grasp.holds(perturbed)) return perturbed;
  }
  checkStartAndGoalFree(scenario);  // says which, where no perturbation is at fault
  throw InputError("scenario " + scenario.name + ": perturb: in each of " +
                   std::to_string(kMaxDraws) + " draws start or goal touched the environment" +
                   (isArm(scenario.robot) ? ", or the gripper could not hold the object" : "") +
                   "; lower perturb.position and perturb.angle or widen the clearance");
}

}  // namespace smore
