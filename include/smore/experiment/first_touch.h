// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// Legs of which a motion is made for the score of its first touch.
constexpr int kLegs = 20;

/// The speeds of a motion: it takes as long as the slower of both needs.
struct MotionSpeed {
  double linear = 0.1;   ///< [m/s], positive
  double angular = 0.5;  ///< [rad/s], positive

  /// [s].
  double timeBetween(const Pose& a, const Pose& b) const;
};

/// The path in kLegs legs that take equally long, each from the end of the one before. A path of
/// fewer than two poses, or of no length, has none.
std::vector<Path> legsOf(const Path& path, const MotionSpeed& speed);

/// The leg on which a pose of the path lies, or the nearest one; the first of equals.
int legAt(const std::vector<Path>& legs, const Pose& pose, const MotionSpeed& speed);

/// Logarithm of the probability [nat] of what came of a motion, docs/scoring.md (E3): that it first
/// touched on the leg `touched`, or nowhere. `survival`: for each leg, the probability that none up
/// to it touches.
double logFirstTouch(const std::vector<double>& survival, const std::optional<int>& touched);

/// The same for one who knows no more than the `risk` of a touch, at all legs alike.
double logUniformTouch(double risk, const std::optional<int>& touched);

}  // namespace smore
