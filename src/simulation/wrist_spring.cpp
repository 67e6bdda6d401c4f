// SPDX-License-Identifier: BSD-3-Clause
#include "smore/simulation/wrist_spring.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace smore {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Vector6 stack(const Vec3& linear, const Vec3& angular) {
  Vector6 vector;
  vector << linear, angular;
  return vector;
}

Matrix6 modalDamping(const Matrix6& stiffness, const Matrix6& inertia, double damping_ratio) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6> modes(stiffness, inertia);
  const Matrix6 shapes = inertia * modes.eigenvectors();
  const Vector6 rates = 2.0 * damping_ratio * modes.eigenvalues().cwiseSqrt();
  return shapes * rates.asDiagonal() * shapes.transpose();
}

}  // namespace

WristSpring::WristSpring(const WristSpringParameters& parameters, const MassProperties& object,
                         double step) {
  const Matrix6 inertia = spatialInertia(object);
  const Matrix6 stiffness = stack(Vec3::Constant(parameters.linear_stiffness),
                                  Vec3::Constant(parameters.angular_stiffness))
                                .asDiagonal();
  const Matrix6 damping = modalDamping(stiffness, inertia, parameters.damping_ratio);
  const Matrix6 implicit = inertia + step * damping + step * step * stiffness;
  const Matrix6 share = implicit.llt().solve(inertia).transpose();
  stiffness_ = share * stiffness;
  damping_ = share * (step * stiffness + damping);
}

Wrench WristSpring::wrench(const WristDeflection& deflection) const {
  const Vector6 wrench = stiffness_ * stack(deflection.position, deflection.rotation) +
                         damping_ * stack(deflection.linear_velocity, deflection.angular_velocity);
  return {wrench.head<3>(), wrench.tail<3>()};
}

WristDeflection WristSpring::deflectionUnder(const Wrench& wrench) const {
  const Vector6 deflection = stiffness_.partialPivLu().solve(stack(wrench.force, wrench.torque));
  WristDeflection result;
  result.position = deflection.head<3>();
  result.rotation = deflection.tail<3>();
  return result;
}

}  // namespace smore
