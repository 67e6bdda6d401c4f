// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "smore/common/result.h"
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

}  // namespace

Scenario perturbScenario(const Scenario& scenario, std::uint64_t seed) {
  Random random(seed);
  for (int draw = 0; draw < kMaxDraws; ++draw) {
    Scenario perturbed = drawPerturbed(scenario, &random);
    SceneCheck check(perturbed);
    if (!check.touches(perturbed.start) && !check.touches(perturbed.goal)) return perturbed;
  }
  checkStartAndGoalFree(scenario);  // says which, where no perturbation is at fault
  throw InputError("scenario " + scenario.name +
                   ": perturb: start or goal touched the environment " + "in each of " +
                   std::to_string(kMaxDraws) +
                   " draws; lower perturb.position and perturb.angle or widen the clearance");
}

}  // namespace smore
