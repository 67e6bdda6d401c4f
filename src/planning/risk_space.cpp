// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_space.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// States are single precision: a pose on the workspace's edge may come back so far outside [m],
// here near the origin and elsewhere of its distance from there.
constexpr double kRounding = 1e-5;
constexpr double kRelativeRounding = 2e-7;

}  // namespace

RiskSpace::RiskSpace(const MotionSpace& space, const Pose& T_map_world, double lever)
    : space_(space), T_map_world_(T_map_world), lever_(lever) {}

RiskState RiskSpace::toState(const Pose& T_world_object) const {
  Pose T_map_object = T_map_world_ * T_world_object;
  if (planar()) T_map_object = projectedToPlane(T_map_object);
  return {T_map_object.translation().cast<float>(),
          Eigen::Quaternionf(T_map_object.linear().cast<float>()).normalized()};
}

Pose RiskSpace::toPose(const RiskState& state) const {
  Pose T_map_object = Pose::Identity();
  T_map_object.linear() = state.rotation.cast<double>().normalized().toRotationMatrix();
  T_map_object.translation() = state.position.cast<double>();
  return T_map_world_.inverse() * T_map_object;
}

bool RiskSpace::contains(const RiskState& state) const {
  const Vec3 origin = T_map_world_.inverse() * state.position.cast<double>();
  const Vec3 rounding =
      Vec3::Constant(std::max(kRounding, kRelativeRounding * origin.cwiseAbs().maxCoeff()));
  return Bounds{space_.workspace.min - rounding, space_.workspace.max + rounding}.contains(origin);
}

RiskState RiskSpace::sample(CounterRandom* random) const {
  Vec3 origin;
  for (int axis = 0; axis < 3; ++axis) {
    const double span = space_.workspace.max[axis] - space_.workspace.min[axis];
    origin[axis] = space_.workspace.min[axis] + span * random->uniform();
  }
  RiskState state;
  state.position = (T_map_world_ * origin).cast<float>();
  if (planar()) {
    state.position.z() = 0.0F;
    state.rotation = turn(M_PI, random);
    return state;
  }
  // Uniform over rotations (Shoemake 1992).
  const double u = random->uniform();
  const double a = 2.0 * M_PI * random->uniform();
  const double b = 2.0 * M_PI * random->uniform();
  state.rotation = Eigen::Quaterniond(std::sqrt(u) * std::cos(b), std::sqrt(1.0 - u) * std::sin(a),
                                      std::sqrt(1.0 - u) * std::cos(a), std::sqrt(u) * std::sin(b))
                       .cast<float>();
  return state;
}

Eigen::Quaternionf RiskSpace::turn(double angle, CounterRandom* random) const {
  const auto amount = static_cast<float>(angle * random->symmetric());
  if (planar()) return Eigen::Quaternionf(Eigen::AngleAxisf(amount, Eigen::Vector3f::UnitZ()));
  Eigen::Vector3f axis;
  do {
    for (int i = 0; i < 3; ++i) axis[i] = static_cast<float>(random->symmetric());
  } while (axis.squaredNorm() > 1.0F || axis.squaredNorm() < 1e-4F);
  return Eigen::Quaternionf(Eigen::AngleAxisf(amount, axis.normalized()));
}

RiskState RiskSpace::sampleNear(const RiskState& center, double distance, double angle,
                                CounterRandom* random) const {
  RiskState state = center;
  for (int axis = 0; axis < (planar() ? 2 : 3); ++axis) {
    state.position[axis] += static_cast<float>(distance * random->symmetric());
  }
  state.rotation = (center.rotation * turn(angle, random)).normalized();
  return state;
}

RiskState RiskSpace::sampleAlongAxis(const RiskState& center, double distance, double angle,
                                     CounterRandom* random) const {
  RiskState state = center;
  const int axes = planar() ? 2 : 3;
  const int choice = random->index(axes + 1);
  if (choice < axes) {
    state.position[choice] += static_cast<float>(distance * random->symmetric());
  } else {
    state.rotation = (center.rotation * turn(angle, random)).normalized();
  }
  return state;
}

}  // namespace smore
