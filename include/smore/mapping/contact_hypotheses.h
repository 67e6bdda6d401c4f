// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "smore/common/geometry.h"
#include "smore/contact/line_of_action.h"
#include "smore/mapping/unit_of_length.h"

namespace smore {

/// Places of a contact that are told apart at most: the bits of four machine words.
constexpr int kCandidates = 256;

/// What a contact is assumed to be: two balls of one radius that touch, one on the object, one on
/// the world, with their common normal on the line of action. Any two such balls stand for matter,
/// so they may never overlap. Lengths are in one unit: in metres where they are used, by default in
/// units of length (unitOfLength): the reach in that of what is held, the others in that of matter.
struct FeatureParameters {
  double radius = 0.25;     ///< of the balls: how deep matter is claimed behind a touched surface
  double tolerance = 0.08;  ///< overlap of two balls that is still no contradiction
  double reach = 6.0;       ///< largest distance of touched matter from the object frame's origin
  double decay = 7.0;  ///< touches grow rarer with the distance r from the origin as exp(-r/decay)

  /// Balls whose centres are nearer than this contradict each other.
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

/// All places where one contact may have been, as draws from what is known of it by itself: where
/// on its line of action, and where the line was, given the uncertainty that it states;
/// docs/belief.md (B1), docs/belief.md (B2).
struct ContactHypotheses {
  int count = 0;      ///< places in use, at most kCandidates
  PointArray object;  ///< centres of the balls on the object, in the object frame [m]
  PointArray world;   ///< centres of the balls on the world, in the map frame [m]
  std::array<float, kCandidates> log_prior{};  ///< normalised over the places
  PointArray object_normal;                    ///< unit, into the object, in the object frame
  PointArray world_normal;                     ///< the same in the map frame
  std::uint64_t id = 0;  ///< hash of what was observed: equal observations have equal ones
  LeverOfContact lever;  ///< of the line, in planar motion in the plane
};

/// The places of a contact at `T_map_object` with the line `line` in the object frame: half of
/// kCandidates, evenly spaced over twice the reach, on an exact line; kCandidates on lines that are
/// scattered about it, normally and evenly (Roberts' sequence), as the line's own standard
/// deviations say. A pitch, which no single contact has, counts as an error of the line's offset.
///
/// `planar`: the motion is in the map frame's x-y plane, in which all bodies count as prisms, so
/// that everything is projected onto it, a pose that is not quite in it too. Nothing where the line
/// passes outside of the reach, is too steep to the plane of planar motion to say where, or has a
/// number that is not finite.
std::optional<ContactHypotheses> contactHypotheses(const Pose& T_map_object,
                                                   const LineOfAction& line,
                                                   const FeatureParameters& parameters,
                                                   bool planar);

}  // namespace smore
