// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "smore/mapping/sampled_worlds.h"

namespace smore {

/// A pose of the object in the map frame, as the search stores it.
struct RiskState {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< [m]
  Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();

  Eigen::Isometry3f pose() const;
};

RiskState interpolate(const RiskState& a, const RiskState& b, float fraction);

/// What a straight motion costs.
struct MotionCost {
  double length = 0.0;          ///< in the metric of RiskMotions [m]
  HypothesisMask touching = 0;  ///< worlds in which it touches
  /// For each world the length on which it touches [m].
  std::array<float, kHypotheses> touching_length{};

  /// The cost of both motions, one after the other.
  MotionCost& operator+=(const MotionCost& other);
};

/// How far apart motions are checked [m]: between two checks no matter moves farther than a share
/// of the distance at which two balls touch, on each of the two ways to move it, so that it cannot
/// pass through another unseen. Infinite for worlds without parts; those that hold no matter yet
/// have a unit, by which they are checked.
double checkDistance(const SampledWorlds& worlds);

/// A place where the robot cannot be, and how far around it no motion may pass, in the metric of
/// RiskMotions [m].
struct BarredPlace {
  RiskState place;
  double radius = 0.0;
};

/// Straight motions in the sampled worlds and the metric in which the search measures them.
class RiskMotions {
 public:
  /// `lever` [m]: what one radian counts. `worlds` is a view. Without `full_turns` no motion about
  /// the map's z axis leads past half a turn from the map's axes.
  RiskMotions(const SampledWorlds& worlds, double lever, bool full_turns = true);

  /// The squared distance of the origins plus the square of lever times angle [m^2], and its root.
  float squaredDistance(const RiskState& a, const RiskState& b) const;
  double distance(const RiskState& a, const RiskState& b) const;

  /// From now on no motion may pass there. Its radius positive.
  void bar(const BarredPlace& barred) { barred_.push_back(barred); }

  bool barsPlaces() const { return !barred_.empty(); }
  /// Whether a motion passes a barred place.
  bool passesBarred(const RiskState& from, const RiskState& to) const;

  /// Cost of a motion; its first pose is not looked at. A forbidden one has an infinite length: one
  /// that turns too far, or passes a barred place.
  MotionCost cost(const RiskState& from, const RiskState& to) const;

  /// The same, or nothing as soon as `hopeless` says so of a part of the cost: all of the length,
  /// and the touching of some of its poses. It is asked a few times; costs only grow.
  std::optional<MotionCost> costUnless(
      const RiskState& from, const RiskState& to,
      const std::function<bool(const MotionCost& part)>& hopeless) const;

  /// Whether no pose of it (but the first) touches in more than `limit` worlds.
  bool within(const RiskState& from, const RiskState& to, int limit) const;

 private:
  int steps(const RiskState& from, const RiskState& to) const;
  bool isForbidden(const RiskState& from, const RiskState& to) const;
  bool turnsTooFar(const RiskState& from, const RiskState& to) const;
  bool passes(const BarredPlace& barred, const RiskState& from, const RiskState& to) const;

  const SampledWorlds* worlds_;
  float lever_;
  bool full_turns_;
  double check_;  ///< distance of neighbouring checks [m]
  std::vector<BarredPlace> barred_;
};

}  // namespace smore
