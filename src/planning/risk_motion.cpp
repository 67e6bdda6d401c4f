// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_motion.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// Checks are this share of the contact distance apart: matter near the lever's length cannot pass
// through other matter between two of them.
constexpr double kCheckShare = 0.3;
constexpr double kCoarsestCheck = 0.05;

}  // namespace

Eigen::Isometry3f RiskState::pose() const {
  Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
  T.linear() = rotation.toRotationMatrix();
  T.translation() = position;
  return T;
}

RiskState interpolate(const RiskState& a, const RiskState& b, float fraction) {
  return {a.position + fraction * (b.position - a.position),
          a.rotation.slerp(fraction, b.rotation)};
}

RiskMotions::RiskMotions(const SampledWorlds& worlds, double lever)
    : worlds_(&worlds), lever_(static_cast<float>(lever)) {
  const double distance = worlds.contactDistance();
  check_ = distance > 0.0 ? kCheckShare * distance : kCoarsestCheck;
}

float RiskMotions::squaredDistance(const RiskState& a, const RiskState& b) const {
  // Series of the squared angle in 1 - |cos(angle / 2)|; 1 % short of pi squared at worst.
  const float x = std::max(0.0F, 1.0F - std::abs(a.rotation.dot(b.rotation)));
  const float squared_angle =
      8.0F * x * (1.0F + x * (1.0F / 6.0F + x * (2.0F / 45.0F + x / 70.0F)));
  return (a.position - b.position).squaredNorm() + lever_ * lever_ * squared_angle;
}

double RiskMotions::distance(const RiskState& a, const RiskState& b) const {
  return std::sqrt(static_cast<double>(squaredDistance(a, b)));
}

int RiskMotions::steps(const RiskState& from, const RiskState& to) const {
  return std::max(1, static_cast<int>(std::ceil(distance(from, to) / check_)));
}

MotionCost RiskMotions::cost(const RiskState& from, const RiskState& to) const {
  MotionCost result;
  result.length = distance(from, to);
  const int count = steps(from, to);
  const auto step = static_cast<float>(result.length / count);
  for (int i = 1; i <= count; ++i) {
    const float fraction = static_cast<float>(i) / static_cast<float>(count);
    const HypothesisMask mask = worlds_->touching(interpolate(from, to, fraction).pose());
    result.touching |= mask;
    for (HypothesisMask left = mask; left != 0; left &= left - 1) {
      result.touching_length[__builtin_ctzll(left)] += step;
    }
  }
  return result;
}

bool RiskMotions::within(const RiskState& from, const RiskState& to, int limit) const {
  const int count = steps(from, to);
  if (limit >= kHypotheses) return true;
  // From the end: it lies farthest from what is known to be within.
  for (int i = count; i >= 1; --i) {
    const float fraction = static_cast<float>(i) / static_cast<float>(count);
    const HypothesisMask mask = worlds_->touching(interpolate(from, to, fraction).pose(), limit);
    if (__builtin_popcountll(mask) > limit) return false;
  }
  return true;
}

}  // namespace smore
