// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "smore/common/geometry.h"
#include "smore/contact/line_of_action.h"

namespace smore {

/// Places on a line of action that are told apart: the bits of two machine words.
constexpr int kCandidates = 128;

/// What a contact is assumed to be: two balls of one radius that touch, one on the object, one on
/// the world, with their common normal on the line of action. Any two such balls stand for matter,
/// so they may never overlap.
struct FeatureParameters {
  double radius = 0.025;  ///< of the balls [m]: how deep matter is claimed behind a touched surface
  double tolerance = 0.008;  ///< overlap of two balls that is still no contradiction [m]
  double reach = 0.6;  ///< largest distance of touched matter from the object frame's origin [m]
  double decay =
      0.35;  ///< touches grow rarer with the distance r from the origin as exp(-r/decay) [m]

  /// Balls whose centres are nearer than this contradict each other [m].
  double conflictDistance() const { return 2.0 * radius - tolerance; }
};

/// Coordinates of many points, each axis in an array of its own for the sake of vector
/// instructions.
struct PointArray {
  std::array<float, kCandidates> x{};
  std::array<float, kCandidates> y{};
  std::array<float, kCandidates> z{};

  Eigen::Vector3f at(int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, const Vec3& point);
};

/// All places on one line of action where the contact may have been.
struct ContactHypotheses {
  int count = 0;      ///< places in use, at most kCandidates
  PointArray object;  ///< centres of the balls on the object, in the object frame [m]
  PointArray world;   ///< centres of the balls on the world, in the map frame [m]
  std::array<float, kCandidates> log_prior{};  ///< normalised over the places
  Vec3 object_normal = Vec3::UnitX();          ///< unit, into the object, in the object frame
  Vec3 world_normal = Vec3::UnitX();           ///< the same in the map frame
  double direction_stddev = 0.0;               ///< of the normal, per axis [rad]
  std::uint64_t id = 0;  ///< hash of what was observed: equal observations have equal ones
};

/// The places of a contact at `T_map_object` with the line `line` in the object frame, a spacing of
/// 2 reach / kCandidates apart. `planar`: the motion is in the map frame's x-y plane, in which all
/// bodies count as prisms, so that everything is projected onto it. Nothing where the line passes
/// outside of the reach, or, in planar motion, is too steep to the plane to say where.
std::optional<ContactHypotheses> contactHypotheses(const Pose& T_map_object,
                                                   const LineOfAction& line,
                                                   const FeatureParameters& parameters,
                                                   bool planar);

}  // namespace smore
