// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "smore/common/geometry.h"
#include "smore/simulation/mass_properties.h"

namespace smore {

/// How far the hand is from where the object hangs, and how fast it moves away: the hand's
/// displacement and velocity relative to the object at the object frame's origin, in the object's
/// axes.
struct WristDeflection {
  Vec3 position = Vec3::Zero();          ///< [m]
  Vec3 rotation = Vec3::Zero();          ///< rotation vector [rad], small
  Vec3 linear_velocity = Vec3::Zero();   ///< [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
};

struct WristSpringParameters {
  double linear_stiffness = 10000.0;  ///< [N/m], positive: 5 N give way by half a millimetre
  double angular_stiffness = 2000.0;  ///< [N m/rad], positive: 5 N at a lever of 0.45 m do the same
  /// Of each vibration mode of the object on the spring, in [0, 1]. At 0.7 a vibration of half a
  /// kilogram falls to a twentieth in 30 ms, and the damper's share of the force at the first touch
  /// stays moderate (10 N at 0.1 m/s).
  double damping_ratio = 0.7;
};

/// The compliance between hand and object: a linear spring and damper in six dimensions at the
/// object frame's origin, integrated implicitly.
///
/// With the object's inertia M, stiffness K and damping D (all 6 x 6), backward Euler over a step h
/// asks for the velocity V' that fulfils
///   M (V' - V) = h K (x + h (Vh - V')) + h D (Vh - V'),
/// x the deflection and Vh the hand's velocity. Solved for the wrench M (V' - V) / h it is
///   M (M + h D + h^2 K)^-1 [K x + (h K + D) (Vh - V)],
/// a constant matrix times the deflection: stable for every mass and step, where an explicit spring
/// needs h <= 0.25 sqrt(m / k) (0.2 ms for a thin rod's spin). The price is a slightly softer
/// spring: a mode of angular frequency w and damping ratio z gives way by 1 + 2 z w h + (w h)^2
/// times as much.
///
/// D is such that each mode of the undamped object on its spring has the given damping ratio:
/// D = M P diag(2 z w) P' M, P the modes (K P = M P diag(w^2), P' M P = 1).
class WristSpring {
 public:
  /// `step` [s], positive.
  WristSpring(const WristSpringParameters& parameters, const MassProperties& object, double step);

  /// Wrench of the hand on the object over the coming step, at the origin and in the axes of the
  /// object frame.
  Wrench wrench(const WristDeflection& deflection) const;

  /// The deflection at rest under which the spring exerts this wrench on the object.
  WristDeflection deflectionUnder(const Wrench& wrench) const;

 private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  Matrix6 stiffness_;  ///< wrench per deflection
  Matrix6 damping_;    ///< wrench per velocity of the deflection
};

}  // namespace smore
