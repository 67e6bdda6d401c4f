// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "smore/scenario/shape.h"

namespace smore {

/// Mass [kg], centre of mass [m] and inertia about the centre of mass [kg m^2], in the object's
/// axes.
struct MassProperties {
  double mass = 0.0;
  Vec3 center = Vec3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// A body of `mass` [kg, positive] spread over the shapes in proportion to their volumes: each
/// solid has the same density, and where solids overlap the material counts twice. `shapes` must
/// not be empty.
MassProperties massProperties(const std::vector<Shape>& shapes, double mass);

/// The same body seen from frame a.
MassProperties transformMass(const Pose& T_a_b, const MassProperties& body_b);

/// Rigidly joined bodies, all in one frame, as one. No bodies: no mass, its centre at the origin.
MassProperties joined(const std::vector<MassProperties>& bodies);

/// Pose of the centre of mass and of right-handed principal axes in the body's frame.
Pose principalFrame(const MassProperties& body);

/// The 6 x 6 inertia about the frame's origin, linear before angular:
/// [m 1, -m [c]x; m [c]x, I_c - m [c]x [c]x].
Eigen::Matrix<double, 6, 6> spatialInertia(const MassProperties& body);

}  // namespace smore
