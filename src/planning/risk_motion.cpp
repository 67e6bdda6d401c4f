// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "smore/common/geometry.h"

namespace smore {
namespace {

// Rounds over a motion, each of every fourth of its poses: most bad motions show in the first.
constexpr int kPasses = 4;

// What is held reaches so far where it is not known [levers].
constexpr double kReachInLevers = 2.0;

// In (-pi, pi] [rad].
double turnAboutZ(const Eigen::Quaternionf& rotation) {
  return wrapped(2.0 * std::atan2(rotation.z(), rotation.w()));
}

}  // namespace

MotionCost& MotionCost::operator+=(const MotionCost& other) {
  length += other.length;
  touching |= other.touching;
  if (other.touching == 0) return *this;
  for (int m = 0; m < kHypotheses; ++m) touching_length[m] += other.touching_length[m];
  return *this;
}

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

double checkDistance(const SampledWorlds& worlds) {
  constexpr double kCheckShare = 0.3;
  const double touching = worlds.contactDistance();
  return touching > 0.0 ? kCheckShare * touching : std::numeric_limits<double>::infinity();
}

RiskMotions::RiskMotions(const SampledWorlds& worlds, double lever, bool full_turns)
    : worlds_(&worlds),
      lever_(static_cast<float>(lever)),
      full_turns_(full_turns),
      check_(checkDistance(worlds) *
             std::min(1.0, kReachInLevers * lever / std::max(lever, worlds.knownReach()))) {}

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

// As MotionSpace::allowsTurn.
bool RiskMotions::turnsTooFar(const RiskState& from, const RiskState& to) const {
  return !full_turns_ && std::abs(turnAboutZ(from.rotation) - turnAboutZ(to.rotation)) > M_PI;
}

bool RiskMotions::passes(const BarredPlace& barred, const RiskState& from,
                         const RiskState& to) const {
  const double length = distance(from, to);
  if (distance(barred.place, from) > length + barred.radius) return false;
  const int count = 1 + static_cast<int>(4.0 * length / barred.radius);
  for (int i = 1; i <= count; ++i) {
    const float fraction = static_cast<float>(i) / static_cast<float>(count);
    if (distance(barred.place, interpolate(from, to, fraction)) < barred.radius) return true;
  }
  return false;
}

bool RiskMotions::passesBarred(const RiskState& from, const RiskState& to) const {
  return std::any_of(barred_.begin(), barred_.end(),
                     [&](const BarredPlace& barred) { return passes(barred, from, to); });
}

bool RiskMotions::isForbidden(const RiskState& from, const RiskState& to) const {
  return turnsTooFar(from, to) || passesBarred(from, to);
}

MotionCost RiskMotions::cost(const RiskState& from, const RiskState& to) const {
  return *costUnless(from, to, [](const MotionCost&) { return false; });
}

std::optional<MotionCost> RiskMotions::costUnless(
    const RiskState& from, const RiskState& to,
    const std::function<bool(const MotionCost& part)>& hopeless) const {
  MotionCost result;
  result.length =
      isForbidden(from, to) ? std::numeric_limits<double>::infinity() : distance(from, to);
  if (hopeless(result)) return std::nullopt;
  if (std::isinf(result.length)) return result;
  const int count = steps(from, to);
  const auto step = static_cast<float>(result.length / count);
  for (int pass = 0; pass < kPasses; ++pass) {
    for (int i = count - pass; i >= 1; i -= kPasses) {
      const float fraction = static_cast<float>(i) / static_cast<float>(count);
      const HypothesisMask mask = worlds_->touching(interpolate(from, to, fraction).pose());
      result.touching |= mask;
      for (HypothesisMask left = mask; left != 0; left &= left - 1) {
        result.touching_length[__builtin_ctzll(left)] += step;
      }
    }
    if (hopeless(result)) return std::nullopt;
  }
  return result;
}

bool RiskMotions::within(const RiskState& from, const RiskState& to, int limit) const {
  if (isForbidden(from, to)) return false;
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
