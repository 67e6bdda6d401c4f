// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "smore/mapping/counter_random.h"

namespace smore {

/// Whether matter may be centred at a point.
using MatterAllowed = std::function<bool(const Eigen::Vector3f& point)>;

/// A flat piece of surface around a touch, and the matter behind it.
struct SurfacePatch {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::UnitX();  ///< unit, outward; in planar motion no z
  float radius = 0.0F;                                ///< [m]
  float step = 0.0F;                                  ///< of the points on it [m], positive
  int depth = 0;  ///< of the matter behind it [steps], not negative
};

/// Points of the patch that can be reached from its centre over neighbours that are `allowed`, the
/// centre left out: matter goes on until free space ends it. In `planar` motion they lie on the
/// tangent and behind all of it, otherwise on a square lattice in the tangent plane, turned at
/// random, and behind the centre.
std::vector<Eigen::Vector3f> growPatch(const SurfacePatch& patch, bool planar,
                                       const MatterAllowed& allowed, CounterRandom* random);

/// How far matter that is `allowed` goes on straight behind the centre, up to the depth [steps].
int depthBehind(const SurfacePatch& patch, const MatterAllowed& allowed);

}  // namespace smore
