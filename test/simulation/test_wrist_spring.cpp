// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "smore/simulation/wrist_spring.h"

namespace smore {
namespace {

constexpr double kStep = 0.001;

MassProperties ball(double mass, double inertia) {
  return {mass, Vec3::Zero(), inertia * Eigen::Matrix3d::Identity()};
}

// How much softer backward Euler makes a mode of this frequency (the header's formula).
double softening(double frequency, double damping_ratio) {
  const double w = frequency * kStep;
  return 1.0 + 2.0 * damping_ratio * w + w * w;
}

TEST(WristSpring, staticWrenchIsTheSoftenedStiffness) {
  const WristSpringParameters parameters;
  const WristSpring spring(parameters, ball(0.5, 0.002), kStep);
  WristDeflection deflection;
  deflection.position = Vec3(0.001, 0, 0);
  deflection.rotation = Vec3(0, 0, 0.002);
  const Wrench wrench = spring.wrench(deflection);
  const double linear = softening(std::sqrt(parameters.linear_stiffness / 0.5), 0.7);
  const double angular = softening(std::sqrt(parameters.angular_stiffness / 0.002), 0.7);
  EXPECT_NEAR(wrench.force.x(), 10.0 / linear, 1e-9);
  EXPECT_NEAR(wrench.torque.z(), 4.0 / angular, 1e-9);
  EXPECT_NEAR(wrench.force.tail<2>().norm() + wrench.torque.head<2>().norm(), 0.0, 1e-9);
}

TEST(WristSpring, massOffTheOriginCouplesVelocityToTorqueButNotDeflectionAtLowFrequency) {
  MassProperties heavy = ball(50.0, 5.0);
  heavy.center = Vec3(0.1, 0, 0);
  const WristSpring spring(WristSpringParameters{}, heavy, kStep);
  WristDeflection deflection;
  deflection.position = Vec3(0, 0.001, 0);
  EXPECT_NEAR(spring.wrench(deflection).force.y(), 10.0, 1.0);
  deflection.position.setZero();
  deflection.linear_velocity = Vec3(0, 0.1, 0);
  EXPECT_GT(spring.wrench(deflection).torque.z(), 1.0);
}

// One axis of a free body on the spring, integrated as the dynamics do it.
double deflectionAfter(double mass, double time, double velocity) {
  const WristSpring spring(WristSpringParameters{}, ball(mass, 1.0), kStep);
  double x = 0.001;
  for (int i = 0; i < std::lround(time / kStep); ++i) {
    WristDeflection deflection;
    deflection.position.x() = x;
    deflection.linear_velocity.x() = velocity;
    velocity -= kStep * spring.wrench(deflection).force.x() / mass;
    x += kStep * velocity;
  }
  return x;
}

TEST(WristSpring, vibrationDecaysAsTheDampedOscillatorDoes) {
  const double w = std::sqrt(10000.0 / 50.0);
  const double damped = w * std::sqrt(1.0 - 0.49);
  const double time = 0.15;
  const double expected = 0.001 * std::exp(-0.7 * w * time) *
                          (std::cos(damped * time) + 0.7 * w / damped * std::sin(damped * time));
  EXPECT_NEAR(deflectionAfter(50.0, time, 0.0), expected, 2e-5);
}

TEST(WristSpring, isStableForMassesFarTooLightForAnExplicitSpring) {
  for (const double mass : {10.0, 0.1, 1e-3, 1e-6}) {
    EXPECT_LT(std::abs(deflectionAfter(mass, 1.0, 0.0)), 1e-4) << mass;
  }
}

}  // namespace
}  // namespace smore
